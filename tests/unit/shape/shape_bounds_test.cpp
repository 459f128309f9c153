// The bounds of every finite shape hold all of it and are tight: rays are shot at it, and more of
// them where its surface reached farthest, so that the box of the points that are met comes close
// to the surface's own.
#include <algorithm>
#include <random>

#include "tests/unit/parser/scene_text.h"
#include "tests/unit/shape/shape_cases.h"

namespace lentray::parser::test {
namespace {

using core::Bounds;
using core::Ray;

/// What the bounds' area may be of that of the points' box, plain and turned or sheared.
struct Factors {
  const char* name;
  double plain, turned;
};
constexpr Factors kTight{"", 1.02, 1.02};
/// Where less is promised: what is searched for in cells or by slices; a solid that goes down to the
/// floor of its box; containers, which are all that is known of a function's surface; and sets of
/// functions whose steps may end beyond them.
constexpr Factors kOthers[] = {
    {"superellipsoid_concave", 1.02, 1.1},
    {"sor", 1.02, 1.08},
    {"sor_open", 1.02, 1.08},
    {"ovus_top_heavy", 1.12, 1.02},
    {"blob", 1.15, 1.2},
    {"blob_sphere", 1.15, 1.2},
    {"blob_far_parts", 1.15, 1.2},
    {"blob_too_weak_alone", 1.15, 1.25},
    {"height_field", 1.02, 1.5},
    {"height_field_water", 1.1, 1.5},
    {"isosurface", 1.3, 3.4},
    {"isosurface_in_sphere", 2.8, 4.2},
    {"parametric", 2.3, 6.2},
    {"parametric_precomputed", 1.3, 2.2},
    {"julia_square", 1.2, 1.2},
    {"julia_default", 1.2, 1.2},
    {"julia_slice", 1.25, 1.35},
    {"julia_cube", 1.2, 1.2},
    {"julia_hypercomplex", 1.8, 2.8},
    {"julia_reciprocal", 1.02, 1.1},
    {"julia_exp", 1.3, 2.9},
};

Factors factors_of(const std::string& name) {
  for (const Factors& f : kOthers) {
    if (name == f.name) return f;
  }
  return kTight;
}

/// Shoots rays and gathers what they meet.
class Sampler {
 public:
  explicit Sampler(const core::Object& object) : m_object(object), m_bounds(object.bounds()) {
    m_reach = length(m_bounds.hi - m_bounds.lo);
  }

  /// All around, wider than the bounds.
  void everywhere(int rays) {
    const Vec3 middle = (m_bounds.lo + m_bounds.hi) * 0.5, half = (m_bounds.hi - m_bounds.lo) * 0.5;
    for (int i = 0; i < rays; ++i) {
      const double wide = i % 4 == 0 ? 1.6 : 1.0, thick = i % 4 == 0 ? 0.1 * m_reach : 0.0;
      shoot(middle + Vec3{(half.x + thick) * wide * m_even(m_random),
                          (half.y + thick) * wide * m_even(m_random),
                          (half.z + thick) * wide * m_even(m_random)});
    }
  }
  /// Closer and closer about the six points that lie farthest out.
  void at_the_ends(int rays) {
    for (double near = 0.1 * m_reach; near > 1e-4 * m_reach; near *= 0.5) {
      for (int i = 0; i < rays; ++i) {
        shoot(m_ends[i % 6] + Vec3{m_even(m_random), m_even(m_random), m_even(m_random)} * near);
      }
    }
  }
  /// A surface of two parameters, in its own space.
  void on(const ShapeCase& shape, const core::Transform& place) {
    constexpr int kSteps = 1000;
    for (int i = 0; i <= kSteps; ++i) {
      for (int k = 0; k <= kSteps; ++k) {
        const Vec3 p =
            place.point(shape.surface(shape.lo.u + (shape.hi.u - shape.lo.u) * i / kSteps,
                                      shape.lo.v + (shape.hi.v - shape.lo.v) * k / kSteps));
        box.include(p);
        ++hits;
        note(p);
      }
    }
  }
  void check_inside(int points) {
    for (int i = 0; i < points; ++i) {
      const Vec3 p = (m_bounds.lo + m_bounds.hi) * 0.5 +
                     Vec3{m_even(m_random), m_even(m_random), m_even(m_random)} * m_reach;
      if (m_object.inside(p)) note(p);
    }
  }

  Bounds box;
  int hits = 0, outside = 0;
  Vec3 astray;  ///< one of those outside

 private:
  void shoot(const Vec3& at) {
    const Vec3 way = normalized(Vec3{m_normal(m_random), m_normal(m_random), m_normal(m_random)});
    const Ray ray{at - way * (3.0 * m_reach), way};
    m_found.clear();
    m_object.all(ray, 1e-6, Bounds::kInf, m_found, {m_lists, core::RayKind::kShadow});
    for (const core::Hit& hit : m_found) {
      const Vec3 p = ray.at(hit.t);
      for (int axis = 0; axis < 3; ++axis) {
        if (hits == 0 || p[axis] < m_ends[2 * axis][axis]) m_ends[2 * axis] = p;
        if (hits == 0 || p[axis] > m_ends[2 * axis + 1][axis]) m_ends[2 * axis + 1] = p;
      }
      box.include(p);
      ++hits;
      note(p);
    }
  }
  void note(const Vec3& p) {
    const Vec3 slack(1e-7 * m_reach);
    if (Bounds{m_bounds.lo - slack, m_bounds.hi + slack}.contains(p)) return;
    ++outside;
    astray = p;
  }

  const core::Object& m_object;
  Bounds m_bounds;
  double m_reach;
  Vec3 m_ends[6];
  std::mt19937 m_random{5};
  std::uniform_real_distribution<double> m_even{-1.0, 1.0};
  std::normal_distribution<double> m_normal;
  std::vector<core::Hit> m_found;
  core::HitLists m_lists;
};

class UnitShapeBounds : public ::testing::TestWithParam<ShapeCase> {};

TEST_P(UnitShapeBounds, HoldAllAndAreTight) {
  for (const auto& placing : kPlacings) {
    SceneText text(std::string("object { ") + GetParam().sdl + " " + placing.sdl + " }",
                   with_fonts());
    const core::SceneParts parts = text.build();
    ASSERT_EQ(parts.objects.size(), 1u);
    const core::Object& object = *parts.objects[0];
    ASSERT_TRUE(object.bounds().is_finite());
    Sampler sampler(object);
    if (GetParam().surface) {
      sampler.on(GetParam(), placing.place);
    } else {
      sampler.everywhere(3000);
      sampler.at_the_ends(600);
    }
    ASSERT_GT(sampler.hits, 100);
    if (object.solid_bounds().is_finite()) sampler.check_inside(2000);
    EXPECT_EQ(sampler.outside, 0) << placing.name << ", one at " << sampler.astray.x << ' '
                                  << sampler.astray.y << ' ' << sampler.astray.z;
    const double factor = object.bounds().surface() / sampler.box.surface();
    const Factors most = factors_of(GetParam().name);
    EXPECT_LE(factor, placing.sdl[0] == '\0' ? most.plain : most.turned) << placing.name;
    RecordProperty(placing.name, std::to_string(factor));
  }
}

INSTANTIATE_TEST_SUITE_P(Each, UnitShapeBounds, ::testing::ValuesIn(kShapeCases),
                         [](const auto& one) { return std::string(one.param.name); });

}  // namespace
}  // namespace lentray::parser::test
