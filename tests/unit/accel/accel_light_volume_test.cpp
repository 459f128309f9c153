// Volumes of light buffers against the objects' own tests, at the very edges: between a lit and a
// dark point a line is halved until no number is left between them.
#include "core/accel/light_volume.h"

#include <gtest/gtest.h>

#include <functional>

#include "core/accel/light_buffer.h"
#include "core/object/leaf.h"
#include "core/shape/box.h"
#include "core/shape/cone.h"
#include "core/shape/cylinder.h"
#include "core/shape/polygon.h"
#include "core/shape/prism.h"
#include "core/shape/sphere.h"
#include "core/shape/torus.h"
#include "core/shape/triangle.h"
#include "tests/unit/shape/random_objects.h"

using namespace lentray::core;
using namespace lentray::test;

namespace {

/// A scene of one object about `middle`.
class Edges {
 public:
  Edges(SceneMaker& make, std::unique_ptr<Leaf> object, const Vec3& light, const Vec3& middle,
        double size, double tolerance)
      : m_make(make), m_light(light), m_middle(middle), m_size(size), m_tolerance(tolerance) {
    object->set_opaque(true);
    m_objects.push_back(std::move(object));
    m_buffer = std::make_unique<LightBuffer>(light, m_objects, tolerance, 1024);
  }

  void hammer(int times) {
    for (int i = 0; i < times && !::testing::Test::HasFatalFailure(); ++i) {
      Vec3 a = place(), b = m_make.integer(4) == 0 ? along(a) : place();
      const bool dark = blocked(a);
      if (blocked(b) == dark) continue;
      ++m_edges;
      for (int k = 0; k < 60; ++k) {
        const Vec3 middle = (a + b) * 0.5;
        (blocked(middle) == dark ? a : b) = middle;
      }
    }
  }
  int edges() const { return m_edges; }
  int lit() const { return m_lit; }
  int lit_tested() const { return m_lit_tested; }

 private:
  /// Before, in or behind the object.
  Vec3 place() {
    const Vec3 at = m_middle + m_make.point() * (1.5 * m_size);
    const double far = m_make.integer(8) == 0 ? 100.0 : 2.0;
    return m_light + (at - m_light) * (0.6 + far * m_make.unit());
  }
  Vec3 along(const Vec3& p) { return m_light + (p - m_light) * (0.3 + 2.0 * m_make.unit()); }

  /// What the object says, which must be what the buffer says.
  bool blocked(const Vec3& point) {
    const Vec3 to = m_light - point;
    const double distance = length(to), reach = distance - m_tolerance;
    const Ray ray{point, to / distance};
    LightBuffer::Spot spot;
    m_buffer->locate(point, spot);
    if (!m_buffer->serves(spot, distance) || !(reach > m_tolerance)) return false;
    const bool expected = m_objects[0]->any(ray, m_tolerance, reach, {m_lists, RayKind::kShadow});
    Counters counters;
    const Object* found =
        m_buffer->any_opaque(spot, ray, m_tolerance, reach, m_lists, &counters).blocker;
    EXPECT_EQ(found != nullptr, expected)
        << "lost at " << point.x << " " << point.y << " " << point.z;
    if (!expected && spot.cell) {
      ++m_lit;
      m_lit_tested += counters.primitive_tests > 0;
    }
    return expected;
  }

  SceneMaker& m_make;
  Vec3 m_light, m_middle;
  double m_size, m_tolerance;
  std::vector<std::unique_ptr<Object>> m_objects;
  std::unique_ptr<LightBuffer> m_buffer;
  HitLists m_lists;
  int m_edges = 0, m_lit = 0, m_lit_tested = 0;
};

struct Kind {
  const char* name;
  /// Fits in a ball of that size about the middle.
  std::function<std::unique_ptr<Shape>(SceneMaker&, const Vec3&, double)> shape;
  bool moved = false;  ///< made about the origin
};

std::unique_ptr<Shape> plate(const Vec3& at, const Vec3& u, const Vec3& v, int corners) {
  std::vector<Vec3> p;
  for (int i = 0; i <= corners; ++i) {
    const double angle = 6.283185307179586 * (i % corners) / corners;
    p.push_back(at + u * std::cos(angle) + v * std::sin(angle));
  }
  return std::make_unique<Polygon>(std::move(p));
}

const Kind kKinds[] = {
    {"triangle",
     [](SceneMaker& make, const Vec3& at, double size) {
       const auto corner = [&] { return at + make.point() * size; };
       return std::make_unique<Triangle>(corner(), corner(), corner());
     }},
    {"needle",
     [](SceneMaker& make, const Vec3& at, double size) {
       const Vec3 a = at + make.point() * size, b = at + make.point() * size;
       return std::make_unique<Triangle>(
           a, b, b + make.point() * (size * std::pow(10.0, -8.0 * make.unit())));
     }},
    {"quad",
     [](SceneMaker& make, const Vec3& at, double size) {
       const Vec3 n = normalized(make.point()),
                  u = normalized(cross(n, Vec3{0.1, 0.7, 0.3})) * size;
       return plate(at, u, cross(n, u) * 0.5, 4);
     }},
    {"plate",
     [](SceneMaker& make, const Vec3& at, double size) {
       const Vec3 n = normalized(make.point()),
                  u = normalized(cross(n, Vec3{0.1, 0.7, 0.3})) * size;
       return plate(at, u, cross(n, u), 9);
     }},
    {"dart",  // not convex
     [](SceneMaker&, const Vec3& at, double size) {
       const Vec3 x{size, 0, 0}, y{0, size, 0};
       return std::make_unique<Polygon>(
           std::vector<Vec3>{at - x, at + y, at + x, at + y * 0.3, at - x});
     }},
    {"sphere",
     [](SceneMaker& make, const Vec3& at, double size) {
       return std::make_unique<Sphere>(at + make.point() * (0.5 * size), 0.5 * size * make.unit());
     }},
    {"box",
     [](SceneMaker&, const Vec3& at, double size) {
       return std::make_unique<Box>(at - Vec3(0.5 * size), at + Vec3{0.5, 0.2, 0.4} * size);
     }},
    {"cone",
     [](SceneMaker& make, const Vec3& at, double size) {
       const auto corner = [&] { return at + make.point() * (0.7 * size); };
       return std::make_unique<Cone>(corner(), 0.3 * size * make.unit(), corner(),
                                     make.integer(2) * 0.2 * size * make.unit(),
                                     make.integer(2) == 0);
     }},
    {"flat cone",
     [](SceneMaker& make, const Vec3& at, double size) {
       const Vec3 thin = make.point() * (size * std::pow(10.0, -5.0 * make.unit()));
       return std::make_unique<Cone>(at, 0.5 * size, at + thin, 0.1 * size, false);
     }},
    {"cylinder",
     [](SceneMaker& make, const Vec3& at, double size) {
       const auto corner = [&] { return at + make.point() * (0.7 * size); };
       return std::make_unique<Cylinder>(corner(), corner(), 0.3 * size * make.unit(),
                                         make.integer(2) == 0);
     }},
    {"torus",
     [](SceneMaker&, const Vec3&, double size) {
       return std::make_unique<Torus>(0.6 * size, 0.2 * size);
     },
     true},
    {"turned box",
     [](SceneMaker& make, const Vec3&, double size) {
       return std::make_unique<Box>(Vec3{-0.3, -0.5, -0.1} * size,
                                    Vec3{0.4, 0.2, 0.4 * make.unit()} * size);
     },
     true},
    {"letter",
     [](SceneMaker& make, const Vec3&, double size) {
       const Vec2 a{-0.5 * size, -0.4 * size}, b{0.5 * size, -0.3 * size},
           c{0.1 * size, 0.6 * size};
       std::vector<CurvePiece> pieces{CurvePiece::line(a, b),
                                      CurvePiece::conic(b, {0.2 * size, 0.0}, c),
                                      CurvePiece::line(c, a)};
       return std::make_unique<Prism>(
           "text", std::make_shared<const Outline>(std::move(pieces)), Prism::Sweep::kAlongZ, 0.0,
           0.3 * size * std::pow(10.0, -4.0 * make.unit()), make.integer(2) == 0);
     },
     true},
};

struct Place {
  double size, light, origin;  ///< light: its distance, origin: that of all, in sizes
};

class UnitCoreLightVolume : public ::testing::TestWithParam<Place> {};

TEST_P(UnitCoreLightVolume, LosesNothingAtTheEdges) {
  const auto [size, light, origin] = GetParam();
  SceneMaker make({"edges", 1.0, 0.1, {0, 0, 0}, 3.0, false, false});
  int all = 0;
  const Vec3 middle = Vec3{0.3, -0.8, 0.5} * (origin * size);
  for (const Kind& kind : kKinds) {
    int edges = 0, lit = 0, tested = 0;
    for (int i = 0; i < 40 && !HasFailure(); ++i) {
      auto shape = kind.shape(make, middle, size);
      if (!shape || shape->bounds().is_empty()) continue;
      const Transform turn =
          kind.moved
              ? Transform::rotation(make.point() * 180.0).then(Transform::translation(middle))
              : Transform();
      const Vec3 from = middle + normalized(make.point()) * (light * size);
      Edges scene(make, std::make_unique<Leaf>(std::move(shape), turn), from, middle, size,
                  1e-3 * std::min(1.0, size));
      scene.hammer(300);
      edges += scene.edges();
      lit += scene.lit();
      tested += scene.lit_tested();
    }
    ASSERT_FALSE(HasFailure()) << kind.name;
    all += edges;
    RecordProperty(kind.name, std::to_string(edges) + " edges, lit and tested " +
                                  std::to_string(tested) + " of " + std::to_string(lit));
  }
  EXPECT_GT(all, 3000);  // small and far polygons are no polygons to stock
}

INSTANTIATE_TEST_SUITE_P(Places, UnitCoreLightVolume,
                         ::testing::Values(Place{1.0, 5.0, 0.0}, Place{1e-5, 5.0, 0.0},
                                           Place{1e5, 5.0, 0.0}, Place{1.0, 1.1, 0.0},
                                           Place{1.0, 2000.0, 0.0}, Place{1.0, 5.0, 1e5},
                                           Place{1e3, 5.0, 1e4}, Place{1e-5, 50.0, 1e3},
                                           Place{1e5, 20.0, 1e2}));

/// Of points that a triangle does not darken, few ask the triangle: those beside it by its outline, those
/// on it by its plane.
TEST(UnitCoreLightVolumeRules, MostLitPointsAskNothing) {
  const LightVolumes volumes(20.0);
  const Vec3 a{-1, -1, 5}, b{2, -1, 6}, c{0, 2, 5};
  const LightVolume volume = volumes.triangle(a, b, c, 5.0);
  SceneMaker make({"rules", 1.0, 0.1, {0, 0, 0}, 3.0, false, false});
  const auto outside = [&](const Vec3& p) {
    return LightProbe(p, std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)}), 1e-3, 20.0)
        .is_outside(volume);
  };
  for (int i = 0; i < 10000; ++i) {
    const double s = make.unit(), t = make.unit() * (1.0 - s);
    const Vec3 on = a + (b - a) * s + (c - a) * t;
    EXPECT_TRUE(outside(on));  // its own points are nearer than t_min
    EXPECT_TRUE(outside(on * 0.999));
    EXPECT_FALSE(outside(on * 1.001));
    EXPECT_FALSE(outside(on * 3.0));
    const Vec3 beyond = a + (a - b) * (1e-4 + s) + (c - a) * t;  // outside of the edge from a to c
    EXPECT_TRUE(outside(beyond * 1.5));
  }
  EXPECT_FALSE(outside({1e3, 0, 30}));  // beyond the reach nothing is known
  EXPECT_FALSE(outside({1e300, 1e300, 1e300}));
  EXPECT_FALSE(LightProbe({3, 2, 7}, 7.0, 1e-3, 20.0).is_outside(LightVolume()));
}

/// The same of a box that was turned, by four of the six edges of its outline.
TEST(UnitCoreLightVolumeRules, PointsAroundATurnedBoxAskNothing) {
  const LightVolumes volumes(20.0);
  const Transform turn =
      Transform::rotation({20, 30, 40}).then(Transform::translation({0.5, -0.3, 6}));
  std::vector<Vec3> corners;
  add_corners({{-1, -0.6, -0.4}, {1, 0.6, 0.4}}, corners);
  for (Vec3& p : corners) p = turn.point(p);
  LightVolume volume, unwanted;
  volumes.box(corners, 4.0, Bounds::kInf, volume);
  volumes.box(corners, 4.0, 1e-3, unwanted);
  SceneMaker make({"rules", 1.0, 0.1, {0, 0, 0}, 3.0, false, false});
  const auto outside = [&](const LightVolume& of, const Vec3& p) {
    return LightProbe(p, std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)}), 1e-3, 20.0)
        .is_outside(of);
  };
  int beside = 0, kept = 0;
  for (int i = 0; i < 10000; ++i) {
    const Vec3 in =
        turn.point({2.0 * make.unit() - 1.0, 1.2 * make.unit() - 0.6, 0.8 * make.unit() - 0.4});
    EXPECT_FALSE(outside(volume, in * 1.8));
    EXPECT_FALSE(outside(unwanted, in * 1.8));
    const Vec3 at = Vec3{0.5, -0.3, 6.0} * 1.8 + make.point() * 3.0;
    beside += outside(volume, at);
    kept += outside(unwanted, at);
  }
  EXPECT_GT(beside, 5000);
  EXPECT_LT(kept, beside);  // its face alone
}

}  // namespace
