// What spares work changes no bits: every shape gives the same answers with its boxes and hierarchies
// as without, whatever part of a ray is asked for; and meshes and CSG the same as their parts do.
#include <algorithm>
#include <bit>
#include <random>
#include <sstream>

#include "core/object/leaf.h"
#include "core/shape/mesh.h"
#include "tests/unit/parser/scene_text.h"
#include "tests/unit/shape/plain_shapes.h"
#include "tests/unit/shape/shape_cases.h"
#include "tests/unit/shape/shape_cases_of_many.h"

namespace lentray::parser::test {
namespace {

using core::Bounds;
using core::Hit;
using core::Ray;

bool shape_shortcuts_same(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}
bool shape_shortcuts_same(const Vec3& a, const Vec3& b) {
  return shape_shortcuts_same(a.x, b.x) && shape_shortcuts_same(a.y, b.y) &&
         shape_shortcuts_same(a.z, b.z);
}
/// Leaves of two copies of an object are told apart by their place among its leaves.
using Leaves = std::vector<const core::Leaf*>;

struct Found {
  Hit hit;
  std::size_t leaf;
  Vec3 normal;
};

bool shape_shortcuts_same(const Found& a, const Found& b) {
  return shape_shortcuts_same(a.hit.t, b.hit.t) && a.leaf == b.leaf &&
         a.hit.shape.element == b.hit.shape.element &&
         shape_shortcuts_same(a.hit.shape.u, b.hit.shape.u) &&
         shape_shortcuts_same(a.hit.shape.v, b.hit.shape.v) &&
         shape_shortcuts_same(a.normal, b.normal);
}

bool shape_shortcuts_same(const std::vector<Found>& a, const std::vector<Found>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Found& x, const Found& y) { return shape_shortcuts_same(x, y); });
}

/// An object or its PlainObject, the object's leaves, and the answers.
template <class Asked>
class Answers {
 public:
  Answers(const Asked& asked, const core::Object& object) : m_object(asked) {
    object.leaves(m_leaves);
  }

  std::vector<Found> all(const Ray& ray, double t_min, double t_max) {
    std::vector<Hit> hits;
    m_object.all(ray, t_min, t_max, hits, {m_lists, core::RayKind::kShadow});
    std::vector<Found> found;
    for (const Hit& hit : hits) found.push_back(describe(ray, hit));
    std::sort(found.begin(), found.end(), [](const Found& a, const Found& b) {
      return std::tuple(a.hit.t, a.leaf, a.hit.shape.element, a.hit.shape.u) <
             std::tuple(b.hit.t, b.leaf, b.hit.shape.element, b.hit.shape.u);
    });
    return found;
  }
  /// Nothing, or the nearest.
  std::vector<Found> nearest(const Ray& ray, double t_min, double t_max) {
    Hit hit;
    if (!m_object.nearest(ray, t_min, t_max, hit, {m_lists, core::RayKind::kShadow})) return {};
    return {describe(ray, hit)};
  }
  bool any(const Ray& ray, double t_min, double t_max) {
    return m_object.any(ray, t_min, t_max, {m_lists, core::RayKind::kShadow});
  }
  bool inside(const Vec3& p) const { return m_object.inside(p); }

 private:
  Found describe(const Ray& ray, const Hit& hit) const {
    const auto place = std::find(m_leaves.begin(), m_leaves.end(), hit.leaf) - m_leaves.begin();
    return {hit, static_cast<std::size_t>(place), hit.leaf->normal(ray.at(hit.t), hit.shape)};
  }

  const Asked& m_object;
  Leaves m_leaves;
  core::HitLists m_lists;
};

/// ShapeShortcutsRays at a box and from within it, most in any direction, some along axes, some from afar.
class ShapeShortcutsRays {
 public:
  explicit ShapeShortcutsRays(const Bounds& box)
      : m_middle((box.lo + box.hi) * 0.5), m_half((box.hi - box.lo) * 0.5) {}

  Vec3 point() {
    const Vec3 wide = m_half * 1.1;
    return m_middle +
           Vec3{wide.x * m_even(m_random), wide.y * m_even(m_random), wide.z * m_even(m_random)};
  }
  Ray next() {
    const int kind = m_count++ % 8;
    Vec3 way = normalized(Vec3{m_normal(m_random), m_normal(m_random), m_normal(m_random)});
    if (kind == 7) {
      way = Vec3{};
      const double forward = m_even(m_random) < 0.0 ? -1.0 : 1.0;
      const int axis = m_count / 8 % 3;
      (axis == 0 ? way.x : axis == 1 ? way.y : way.z) = forward;
    }
    constexpr double kAway[] = {0.0, 1.0, 4.0, 4.0, 4.0, 4.0, 1e4, 4.0};
    const double speed = kind == 3 ? 0.37 : 1.0;
    return {point() - way * (kAway[kind] * length(m_half)), way * speed};
  }

 private:
  Vec3 m_middle, m_half;
  int m_count = 0;
  std::mt19937 m_random{11};
  std::uniform_real_distribution<double> m_even{-1.0, 1.0};
  std::normal_distribution<double> m_normal;
};

/// A scene of one object, placed.
class Placed {
 public:
  Placed(const ShapeCase& shape, const char* place)
      : m_text(std::string("object { ") + shape.sdl + " " + place + " }", with_fonts()),
        m_parts(m_text.build()) {}
  core::Object& object() { return *m_parts.objects.at(0); }

 private:
  SceneText m_text;
  core::SceneParts m_parts;
};

constexpr double kFrom = 1e-6;

std::string described(const Ray& ray, const std::vector<Found>& found,
                      const std::vector<Found>& expected) {
  std::ostringstream text;
  text.precision(17);
  const auto vector = [&](const Vec3& v) {
    text << '<' << v.x << ',' << v.y << ',' << v.z << "> ";
  };
  vector(ray.origin);
  vector(ray.direction);
  for (const auto* list : {&found, &expected}) {
    text << (list == &found ? "found:" : "; expected:");
    for (const Found& f : *list)
      text << ' ' << f.hit.t << " of " << f.leaf << '/' << f.hit.shape.element;
  }
  return text.str();
}

class UnitShapeShortcuts : public ::testing::TestWithParam<ShapeCase> {
 protected:
  /// Parametric surfaces take long to meet.
  static int rays() { return GetParam().surface ? 40 : 1500; }
};

TEST_P(UnitShapeShortcuts, AreOnlyShort) {
  for (const auto& placing : kPlacings) {
    Placed usual(GetParam(), placing.sdl), plain(GetParam(), placing.sdl);
    const core::PlainObject asked_plainly(plain.object());
    Answers<core::Object> shorter(usual.object(), usual.object());
    Answers<core::PlainObject> longer(asked_plainly, plain.object());
    ShapeShortcutsRays rays(usual.object().bounds());
    int met = 0, different = 0;
    std::string example;
    for (int i = 0; i < this->rays(); ++i) {
      const Ray ray = rays.next();
      const auto hits = longer.all(ray, kFrom, Bounds::kInf);
      const auto first = longer.nearest(ray, kFrom, Bounds::kInf);
      const Vec3 p = rays.point();
      met += !hits.empty();
      const auto all = shorter.all(ray, kFrom, Bounds::kInf);
      if (shape_shortcuts_same(all, hits) &&
          shape_shortcuts_same(shorter.nearest(ray, kFrom, Bounds::kInf), first) &&
          shorter.any(ray, kFrom, Bounds::kInf) == !first.empty() &&
          shorter.inside(p) == longer.inside(p)) {
        continue;
      }
      ++different;
      example = described(ray, all, hits);
    }
    EXPECT_GT(met, 0) << placing.name;
    EXPECT_EQ(different, 0) << placing.name << ", of " << met << " met; " << example;
  }
}

/// Neighbours in a hierarchy shorten the rays that reach an object.
TEST_P(UnitShapeShortcuts, OfTheRayToo) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  for (const auto& placing : kPlacings) {
    Placed placed(GetParam(), placing.sdl);
    Answers<core::Object> answers(placed.object(), placed.object());
    ShapeShortcutsRays rays(placed.object().bounds());
    int different = 0;
    for (int i = 0; i < this->rays(); ++i) {
      const Ray ray = rays.next();
      const auto first = answers.nearest(ray, kFrom, Bounds::kInf);
      if (first.empty()) continue;
      const double t = first[0].hit.t;
      for (const double to :
           {t * (0.5 + 0.5 * share(random)), t * (1.0 + share(random)), std::nextafter(t, 1e300)}) {
        const auto expected = to > t ? first : std::vector<Found>{};
        different += !shape_shortcuts_same(answers.nearest(ray, kFrom, to), expected) ||
                     answers.any(ray, kFrom, to) != !expected.empty();
      }
    }
    EXPECT_EQ(different, 0) << placing.name;
  }
}

const auto name_of = [](const auto& one) { return std::string(one.param.name); };
INSTANTIATE_TEST_SUITE_P(Each, UnitShapeShortcuts, ::testing::ValuesIn(kShapeCases), name_of);
INSTANTIATE_TEST_SUITE_P(OfMany, UnitShapeShortcuts, ::testing::ValuesIn(shapes_of_many()),
                         name_of);

/// The faces of a mesh, each by itself.
TEST(UnitShapeShortcutsOfMesh, AreThoseOfItsFaces) {
  for (const ShapeCase& shape : shapes_of_many()) {
    if (std::string(shape.name) != "mesh_of_100") continue;
    Placed placed(shape, "");
    const auto& leaf = dynamic_cast<const core::Leaf&>(placed.object());
    const auto& mesh = dynamic_cast<const core::Mesh&>(leaf.shape()).triangles();
    ShapeShortcutsRays rays(placed.object().bounds());
    int met = 0;
    for (int i = 0; i < 3000; ++i) {
      const Ray ray = rays.next();
      const core::ShearedRay sheared(ray);
      core::TriangleMesh::FaceHit found, expected;
      for (std::uint32_t face = 0; face < mesh.data().faces.size(); ++face) {
        const auto& v = mesh.data().faces[face];
        const auto& p = mesh.data().vertices;
        core::TriangleHit hit;
        if (!core::intersect_triangle(sheared, p[v[0]], p[v[1]], p[v[2]], hit)) continue;
        if (!(hit.t > kFrom) || (expected.face != core::kNoIndex && !(hit.t < expected.t)))
          continue;
        expected = {hit.t, hit.wb, hit.wc, face};
      }
      ASSERT_EQ(mesh.nearest(ray, kFrom, Bounds::kInf, found), expected.face != core::kNoIndex);
      if (expected.face == core::kNoIndex) continue;
      ++met;
      EXPECT_TRUE(found.face == expected.face && shape_shortcuts_same(found.t, expected.t) &&
                  shape_shortcuts_same(found.wb, expected.wb) &&
                  shape_shortcuts_same(found.wc, expected.wc));
    }
    EXPECT_GT(met, 500);
  }
}

}  // namespace
}  // namespace lentray::parser::test
