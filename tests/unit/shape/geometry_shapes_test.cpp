// Analytic truths of the primitives: hits, normals, solids, bounds, transforms.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "core/object/leaf.h"
#include "core/shape/box.h"
#include "core/shape/cone.h"
#include "core/shape/cylinder.h"
#include "core/shape/disc.h"
#include "core/shape/mesh.h"
#include "core/shape/plane.h"
#include "core/shape/polygon.h"
#include "core/shape/quadric.h"
#include "core/shape/smooth_triangle.h"
#include "core/shape/sphere.h"
#include "core/shape/torus.h"
#include "core/shape/triangle.h"
#include "tests/unit/shape/geometry_help.h"

namespace lentray::core {
namespace {

using geometry_test::Random;
constexpr double kGeometryShapesInf = Bounds::kInf;

/// A kind of shape, and how far a point is off its surface (0 on it).
struct GeometryShapesKind {
  std::string name;
  std::function<std::unique_ptr<Shape>()> make;
  std::function<double(const Vec3&)> off;
};

double radial(const Vec3& p) { return std::hypot(p.x, p.z); }

std::unique_ptr<Shape> tetrahedron() {
  MeshData data;
  data.vertices = {{-1, -1, -1}, {1, -1, -1}, {0, -1, 1}, {0, 1, 0}};
  data.faces = {{0, 1, 2}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  return std::make_unique<Mesh>(std::make_shared<const TriangleMesh>(std::move(data)),
                                Vec3{0.1, 1, 0.03}, false);
}

/// Solids, standing about the origin within a distance of 2.
std::vector<GeometryShapesKind> solids() {
  return {
      {"sphere",
       [] {
         return std::make_unique<Sphere>(Vec3{0.1, 0.2, 0.3}, 0.8);
       },
       [](const Vec3& p) {
         return length(p - Vec3{0.1, 0.2, 0.3}) - 0.8;
       }},
      {"box",
       [] {
         return std::make_unique<Box>(Vec3{1, -0.5, -0.7}, Vec3{-0.4, 0.6, 0.9});
       },
       [](const Vec3& p) {
         const Vec3 a{std::max(-0.4 - p.x, p.x - 1.0), std::max(-0.5 - p.y, p.y - 0.6),
                      std::max(-0.7 - p.z, p.z - 0.9)};
         return std::max({a.x, a.y, a.z});
       }},
      {"cylinder",
       [] {
         return std::make_unique<Cylinder>(Vec3{0, -0.6, 0}, Vec3{0, 0.9, 0}, 0.7);
       },
       [](const Vec3& p) {
         return std::max({radial(p) - 0.7, -0.6 - p.y, p.y - 0.9});
       }},
      {"cone",
       [] {
         return std::make_unique<Cone>(Vec3{0, -0.5, 0}, 1.0, Vec3{0, 1, 0}, 0.25);
       },
       [](const Vec3& p) {
         return std::max({radial(p) - (1.0 - 0.5 * (p.y + 0.5)), -0.5 - p.y, p.y - 1.0});
       }},
      {"pointed cone",
       [] {
         return std::make_unique<Cone>(Vec3{0, 1, 0}, 0.0, Vec3{0, -1, 0}, 1.0);
       },
       [](const Vec3& p) {
         return std::max({radial(p) - 0.5 * (1.0 - p.y), -1 - p.y, p.y - 1.0});
       }},
      {"torus", [] { return std::make_unique<Torus>(1.0, 0.3); },
       [](const Vec3& p) { return std::hypot(radial(p) - 1.0, p.y) - 0.3; }},
      {"thin torus", [] { return std::make_unique<Torus>(1.0, 0.01); },
       [](const Vec3& p) { return std::hypot(radial(p) - 1.0, p.y) - 0.01; }},
      {"ellipsoid",
       [] {
         return std::make_unique<Quadric>(Vec3{1, 4, 2}, Vec3{}, Vec3{0.2, 0, 0}, -1.0);
       },
       [](const Vec3& p) { return p.x * p.x + 4 * p.y * p.y + 2 * p.z * p.z + 0.2 * p.x - 1.0; }},
      {"mesh", tetrahedron,
       [](const Vec3& p) {
         const double side = (4.0 * std::fabs(p.x) + p.y + 2.0 * p.z - 1.0) / std::sqrt(21.0);
         const double back = (-2.0 * p.z + p.y - 1.0) / std::sqrt(5.0);
         return std::max({-1.0 - p.y, side, back});
       }},
  };
}

TEST(UnitCoreShapes, HitsLieOnTheSurfaceAndSeparateInsideFromOutside) {
  for (const GeometryShapesKind& kind : solids()) {
    Random random(7);
    const auto shape = kind.make();
    int met = 0;
    for (int round = 0; round < 4000; ++round) {
      const Ray ray = random.ray(random.in(0.0, 6.0), 1.0);
      ShapeHits hits;
      shape->all(ray, 1e-9, kGeometryShapesInf, hits);
      std::sort(hits.begin(), hits.end(), [](auto& a, auto& b) { return a.t < b.t; });
      ShapeHit first;
      ASSERT_EQ(shape->nearest(ray, 1e-9, kGeometryShapesInf, first), !hits.empty()) << kind.name;
      EXPECT_EQ(shape->any(ray, 1e-9, kGeometryShapesInf), !hits.empty());
      if (!hits.empty()) {
        EXPECT_EQ(first.t, hits[0].t) << kind.name;
        ++met;
      }
      bool in = kind.off(ray.origin) < 0.0;
      EXPECT_EQ(shape->inside(ray.origin), in) << kind.name;
      double from = 0.0;
      for (const ShapeHit& hit : hits) {
        EXPECT_NEAR(kind.off(ray.at(hit.t)), 0.0, 1e-11) << kind.name;
        const Vec3 middle = ray.at(0.5 * (from + hit.t));
        if (hit.t - from > 1e-6) {
          EXPECT_EQ(shape->inside(middle), in) << kind.name << " " << round;
        }
        in = !in;
        from = hit.t;
      }
      EXPECT_FALSE(in) << kind.name << " odd crossings";
    }
    EXPECT_GT(met, kind.name == "thin torus" ? 20 : 400) << kind.name;
  }
}

TEST(UnitCoreShapes, NormalsPointOutwards) {
  for (const GeometryShapesKind& kind : solids()) {
    if (kind.name == "mesh") continue;  // faces keep the order of their corners
    Random random(8);
    const auto shape = kind.make();
    for (int round = 0; round < 500; ++round) {
      const Ray ray = random.ray(4.0, 1.0);
      ShapeHit hit;
      if (!shape->nearest(ray, 0.0, kGeometryShapesInf, hit)) continue;
      const Vec3 p = ray.at(hit.t), n = normalized(shape->normal(p, hit));
      EXPECT_GT(kind.off(p + n * 1e-5), 0.0) << kind.name;
      EXPECT_LT(kind.off(p - n * 1e-5), 0.0) << kind.name;
      // Steepest: any other direction leaves the surface more slowly.
      const Vec3 other = normalized(n + random.direction() * 0.3);
      EXPECT_GE(kind.off(p + n * 1e-6) + 1e-8, kind.off(p + other * 1e-6)) << kind.name;
    }
  }
}

TEST(UnitCoreShapes, TransformedLeavesMatchTheShapeItself) {
  for (const GeometryShapesKind& kind : solids()) {
    Random random(9);
    for (int round = 0; round < 60; ++round) {
      const Transform t = round % 2 == 0 ? random.similarity() : random.any_transform();
      const Leaf leaf(kind.make(), t);
      const Bounds box = leaf.bounds();
      const auto shape = kind.make();
      HitLists lists;
      for (int k = 0; k < 60; ++k) {
        const Ray local = random.ray(5.0, 1.0);
        const Ray world{t.point(local.origin), t.vector(local.direction)};
        ShapeHit expected;
        Hit hit;
        const bool met = shape->nearest(local, 1e-6, kGeometryShapesInf, expected);
        ASSERT_EQ(leaf.nearest(world, 1e-6, kGeometryShapesInf, hit, {lists, RayKind::kShadow}),
                  met)
            << kind.name;
        EXPECT_EQ(leaf.any(world, 1e-6, kGeometryShapesInf, {lists, RayKind::kShadow}), met);
        EXPECT_EQ(leaf.inside(t.point(local.at(5.0))), shape->inside(local.at(5.0))) << kind.name;
        if (!met) continue;
        EXPECT_NEAR(hit.t, expected.t, 1e-9 * 5.0) << kind.name;
        const Vec3 p = world.at(hit.t);
        for (int i = 0; i < 3; ++i) {
          EXPECT_GE(p[i], box.lo[i] - 1e-12 * length(world.origin)) << kind.name;
          EXPECT_LE(p[i], box.hi[i] + 1e-12 * length(world.origin)) << kind.name;
        }
        const Vec3 n = leaf.normal(p, hit.shape);
        EXPECT_NEAR(length(n), 1.0, 1e-12);
        const Vec3 m = normalized(t.normal(shape->normal(local.at(expected.t), expected)));
        EXPECT_GT(dot(n, m), 1.0 - 1e-9) << kind.name;
      }
    }
  }
}

TEST(UnitCoreShapes, BoundsHoldTheSurfaceAndAreTight) {
  for (const GeometryShapesKind& kind : solids()) {
    Random random(10);
    for (int round = 0; round < 12; ++round) {
      const Transform t = round == 0  ? Transform()
                          : round % 2 ? random.similarity()
                                      : random.any_transform();
      const Leaf leaf(kind.make(), t);
      const Bounds box = leaf.bounds();
      ASSERT_TRUE(box.is_finite()) << kind.name;
      Bounds seen;
      HitLists lists;
      std::vector<Hit> hits;
      const double far = 3.0 * length(box.hi - box.lo);
      for (int k = 0; k < 4000; ++k) {
        // Towards the box's middle and along its axes, so that the extremes are met.
        const Vec3 d = k % 2 ? random.direction()
                             : normalized(Vec3{k % 3 == 0 ? 1.0 : 0.0, k % 3 == 1 ? 1.0 : 0.0,
                                               k % 3 == 2 ? 1.0 : 0.0} +
                                          random.vector(0.02));
        const Vec3 through{random.in(box.lo.x, box.hi.x), random.in(box.lo.y, box.hi.y),
                           random.in(box.lo.z, box.hi.z)};
        const Ray ray{through - d * far, d};
        hits.clear();
        leaf.all(ray, 0.0, kGeometryShapesInf, hits, {lists, RayKind::kShadow});
        for (const Hit& h : hits) seen.include(ray.at(h.t));
      }
      const double slack = 1e-11 * far;
      for (int i = 0; i < 3; ++i) {
        EXPECT_GE(seen.lo[i], box.lo[i] - slack) << kind.name;
        EXPECT_LE(seen.hi[i], box.hi[i] + slack) << kind.name;
      }
      if (kind.name == "thin torus") continue;  // too few rays meet it
      EXPECT_LT(box.surface(), 1.35 * seen.surface()) << kind.name << round;
    }
  }
}

TEST(UnitCoreShapes, AxisParallelRaysThroughExactPlaces) {
  const Sphere sphere({0, 0, 0}, 1.0);
  const Box box({-1, -1, -1}, {1, 1, 1});
  const Cylinder cylinder({0, 0, 0}, {0, 2, 0}, 1.0);
  const Cone cone({0, 0, 0}, 1.0, {0, 2, 0}, 0.0);
  const Torus torus(2.0, 0.5);
  ShapeHit hit;
  ShapeHits hits;
  ASSERT_TRUE(sphere.nearest({{0, 0, -3}, {0, 0, 2}}, 0, kGeometryShapesInf, hit));
  EXPECT_DOUBLE_EQ(hit.t, 1.0);
  ASSERT_TRUE(sphere.nearest({{0, 0, 0}, {0, 0, 1}}, 0, kGeometryShapesInf, hit));
  EXPECT_DOUBLE_EQ(hit.t, 1.0);
  EXPECT_FALSE(sphere.nearest({{0, 0, 3}, {0, 0, 1}}, 0, kGeometryShapesInf, hit));
  EXPECT_FALSE(sphere.nearest({{0, 0, -3}, {0, 0, 1}}, 2.5, 3.5, hit));
  // In the plane of a box's side, along an edge and through a corner.
  EXPECT_TRUE(box.nearest({{1, 0, -5}, {0, 0, 1}}, 0, kGeometryShapesInf, hit));
  EXPECT_DOUBLE_EQ(hit.t, 4.0);
  EXPECT_EQ(hit.element, 4u);
  EXPECT_TRUE(box.nearest({{1, 1, -5}, {0, 0, 1}}, 0, kGeometryShapesInf, hit));
  EXPECT_FALSE(box.nearest({{1.0000001, 0, -5}, {0, 0, 1}}, 0, kGeometryShapesInf, hit));
  EXPECT_TRUE(box.nearest({{-2, -2, -2}, {1, 1, 1}}, 0, kGeometryShapesInf, hit));
  EXPECT_DOUBLE_EQ(hit.t, 1.0);
  // Along the axes of round things.
  ASSERT_TRUE(cylinder.nearest({{0, -3, 0}, {0, 1, 0}}, 0, kGeometryShapesInf, hit));
  EXPECT_DOUBLE_EQ(hit.t, 3.0);
  EXPECT_EQ(hit.element, 1u);
  EXPECT_EQ(cylinder.normal({0, 0, 0}, hit), (Vec3{0, -1, 0}));
  cylinder.all({{0, -3, 0}, {0, 1, 0}}, 0, kGeometryShapesInf, hits);
  ASSERT_EQ(hits.size(), 2u);
  EXPECT_DOUBLE_EQ(hits[1].t, 5.0);
  EXPECT_FALSE(cylinder.nearest({{1.5, -3, 0}, {0, 1, 0}}, 0, kGeometryShapesInf, hit));
  hits.clear();
  cone.all({{0, -3, 0}, {0, 1, 0}}, 0, kGeometryShapesInf, hits);
  ASSERT_EQ(hits.size(), 2u);
  EXPECT_NEAR(hits[0].t, 3.0, 1e-12);
  EXPECT_NEAR(hits[1].t, 5.0, 1e-7);  // the tip
  hits.clear();
  cone.all({{0, 1, -3}, {0, 0, 1}}, 0, kGeometryShapesInf, hits);
  ASSERT_EQ(hits.size(), 2u);
  EXPECT_NEAR(hits[0].t, 2.5, 1e-14);
  hits.clear();
  torus.all({{-5, 0, 0}, {1, 0, 0}}, 0, kGeometryShapesInf, hits);
  ASSERT_EQ(hits.size(), 4u);
  const double expected[4] = {2.5, 3.5, 6.5, 7.5};
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(hits[static_cast<std::size_t>(i)].t, expected[i], 1e-13);
  EXPECT_FALSE(
      torus.nearest({{0, -5, 0}, {0, 1, 0}}, 0, kGeometryShapesInf, hit));  // through the hole
  ASSERT_TRUE(torus.nearest({{2, -5, 0}, {0, 1, 0}}, 0, kGeometryShapesInf, hit));
  EXPECT_NEAR(hit.t, 4.5, 1e-13);
}

TEST(UnitCoreShapes, OpenEndsLetRaysIn) {
  const Cylinder tube({0, 0, 0}, {0, 2, 0}, 1.0, true);
  const Cone funnel({0, 0, 0}, 1.0, {0, 2, 0}, 0.5, true);
  for (const Shape* shape :
       {static_cast<const Shape*>(&tube), static_cast<const Shape*>(&funnel)}) {
    ShapeHit hit;
    ShapeHits hits;
    EXPECT_FALSE(shape->nearest({{0, -3, 0}, {0, 1, 0}}, 0, kGeometryShapesInf, hit));
    shape->all({{0, -0.1, 0}, {1, 1, 0}}, 0, kGeometryShapesInf, hits);
    ASSERT_EQ(hits.size(), 1u);
    EXPECT_EQ(hits[0].element, 0u);
    EXPECT_TRUE(shape->inside({0, 1, 0}));
    EXPECT_FALSE(shape->inside({0, -1, 0}));
  }
}

TEST(UnitCoreShapes, ScalesFromTinyToHuge) {
  for (double s : {1e-6, 1e-3, 1.0, 1e4, 1e7}) {
    for (const GeometryShapesKind& kind : solids()) {
      if (kind.name == "thin torus") continue;
      const Leaf small(kind.make(), Transform::scaling(Vec3(s)));
      const auto shape = kind.make();
      Random random(11);
      HitLists lists;
      int differ = 0;
      for (int k = 0; k < 300; ++k) {
        const Ray local = random.ray(5.0, 1.0);
        const Ray ray{local.origin * s, local.direction};
        ShapeHit expected;
        Hit hit;
        const bool met = shape->nearest(local, 0.0, kGeometryShapesInf, expected);
        if (small.nearest(ray, 0.0, kGeometryShapesInf, hit, {lists, RayKind::kShadow}) != met) {
          ++differ;
        } else if (met) {
          EXPECT_NEAR(hit.t / s, expected.t, 1e-9) << kind.name << " " << s;
        }
      }
      EXPECT_LE(differ, 0) << kind.name << " " << s;
    }
  }
}

TEST(UnitCoreShapes, DetailsFarFromTheOrigin) {
  const Vec3 away{1e7, -2e6, 3e6};
  for (const GeometryShapesKind& kind : solids()) {
    if (kind.name == "thin torus") continue;
    const Leaf leaf(kind.make(), Transform::translation(away));
    const auto shape = kind.make();
    Random random(12);
    HitLists lists;
    int differ = 0, met_count = 0;
    for (int k = 0; k < 500; ++k) {
      const Ray local = random.ray(100.0, 1.0);
      Hit hit;
      ShapeHit expected;
      const bool met = shape->nearest(local, 0.0, kGeometryShapesInf, expected);
      met_count += met;
      const Ray ray{local.origin + away, local.direction};
      if (leaf.nearest(ray, 0.0, kGeometryShapesInf, hit, {lists, RayKind::kShadow}) != met) {
        ++differ;
      } else if (met) {
        const Vec3 n = normalized(shape->normal(local.at(expected.t), expected));
        EXPECT_NEAR(hit.t, expected.t, 1e-7 / std::fabs(dot(n, local.direction))) << kind.name;
      }
    }
    EXPECT_GT(met_count, 20) << kind.name;
    EXPECT_LE(differ, 1) << kind.name;
  }
}

TEST(UnitCorePlane, SidesAndBounds) {
  const Plane plane({0, 2, 0}, 3.0);
  ShapeHit hit;
  ASSERT_TRUE(plane.nearest({{0, 10, 0}, {0, -1, 0}}, 0, kGeometryShapesInf, hit));
  EXPECT_DOUBLE_EQ(hit.t, 7.0);
  EXPECT_FALSE(plane.nearest({{0, 10, 0}, {1, 0, 0}}, 0, kGeometryShapesInf, hit));
  EXPECT_TRUE(plane.inside({0, 2.9, 0}));
  EXPECT_FALSE(plane.inside({0, 3.1, 0}));
  EXPECT_TRUE(plane.inside({5, 3.0, 0}) && plane.holds({5, 3.0, 0}, true));
  EXPECT_FALSE(plane.bounds().is_finite());
  EXPECT_NEAR(plane.bounds().hi.y, 3.0, 1e-9);
  const Transform t = Transform::scaling({1, 2, 1}).then(Transform::rotation({0, 0, 90}));
  const auto moved = plane.baked(t);
  ASSERT_TRUE(moved->nearest({{-10, 1, 5}, {1, 0, 0}}, 0, kGeometryShapesInf,
                             hit));  // y = 6 turned to x = -6
  EXPECT_NEAR(hit.t, 4.0, 1e-12);
}

TEST(UnitCoreDisc, RingAndHalfSpace) {
  const Disc disc({0, 0, 1}, {0, 0, -2}, 2.0, 0.5);
  ShapeHit hit;
  EXPECT_FALSE(disc.nearest({{0, 0, -5}, {0, 0, 1}}, 0, kGeometryShapesInf, hit));
  ASSERT_TRUE(disc.nearest({{1, 0, -5}, {0, 0, 1}}, 0, kGeometryShapesInf, hit));
  EXPECT_DOUBLE_EQ(hit.t, 6.0);
  EXPECT_FALSE(disc.nearest({{2.1, 0, -5}, {0, 0, 1}}, 0, kGeometryShapesInf, hit));
  EXPECT_TRUE(disc.inside({50, 0, 2}));
  EXPECT_FALSE(disc.inside({50, 0, 0}));
  EXPECT_NEAR(disc.bounds().lo.x, -2.0, 1e-9);
  EXPECT_NEAR(disc.bounds().hi.z, 1.0, 1e-9);
}

TEST(UnitCoreTriangle, HitsWeightsAndDegeneracy) {
  const Triangle triangle({0, 0, 0}, {2, 0, 0}, {0, 2, 0});
  ShapeHit hit;
  ASSERT_TRUE(triangle.nearest({{0.5, 0.25, -1}, {0, 0, 1}}, 0, kGeometryShapesInf, hit));
  EXPECT_DOUBLE_EQ(hit.t, 1.0);
  EXPECT_DOUBLE_EQ(hit.u, 0.25);
  EXPECT_DOUBLE_EQ(hit.v, 0.125);
  EXPECT_FALSE(triangle.nearest({{1.5, 1.5, -1}, {0, 0, 1}}, 0, kGeometryShapesInf, hit));
  EXPECT_FALSE(triangle.inside({0.1, 0.1, 0}) || triangle.holds({0.1, 0.1, 5}, true));
  EXPECT_FALSE(triangle.nearest({{-1, 0.5, 0}, {1, 0, 0}}, 0, kGeometryShapesInf, hit));  // edge on
  const Triangle flat({0, 0, 0}, {1, 1, 1}, {2, 2, 2});
  EXPECT_TRUE(flat.is_degenerate());
  EXPECT_TRUE(flat.bounds().is_empty());
}

TEST(UnitCoreTriangle, NeighboursLeaveNoGap) {
  // A fan of triangles around a point; rays to random points of the edges meet one of them.
  Random random(13);
  for (int round = 0; round < 2000; ++round) {
    const Vec3 a = random.vector(1), b = random.vector(1), c = random.vector(1),
               d = random.vector(1);
    const Vec3 target = a + (b - a) * random.in(0.0, 1.0);
    const Vec3 from = target + random.direction() * random.in(0.5, 1000.0);
    const Ray ray{from, target - from};
    const Vec3 side = cross(b - a, ray.direction);
    if (dot(c - a, side) * dot(d - a, side) >= 0.0) continue;  // both on one side: an outline
    ShapeHit hit;
    const bool met = Triangle(a, b, c).nearest(ray, 0.0, kGeometryShapesInf, hit) ||
                     Triangle(b, a, d).nearest(ray, 0.0, kGeometryShapesInf, hit);
    EXPECT_TRUE(met) << round;
  }
}

TEST(UnitCoreSmoothTriangle, InterpolatesNormalsAndDropsImpossibleOnes) {
  const SmoothTriangle s({0, 0, 0}, {-1, 0, -1}, {2, 0, 0}, {1, 0, -1}, {0, 2, 0}, {0, 1, -1});
  ASSERT_FALSE(s.is_degenerate());
  ShapeHit hit;
  ASSERT_TRUE(s.nearest({{1, 0, -1}, {0, 0, 1}}, 0, kGeometryShapesInf, hit));
  const Vec3 n = normalized(s.normal({1, 0, 0}, hit));
  EXPECT_NEAR(n.x, 0.0, 1e-12);
  EXPECT_NEAR(n.z, -1.0, 1e-12);
  EXPECT_TRUE(SmoothTriangle({0, 0, 0}, {0, 0, 1}, {2, 0, 0}, {0, 0, -1}, {0, 2, 0}, {0, 0, 1})
                  .is_degenerate());
}

TEST(UnitCoreQuadric, UnboundedKindsAreBoundedWhereTheyCan) {
  const Quadric tube(Vec3{1, 0, 1}, {}, {}, -4.0);  // x2 + z2 = 4
  EXPECT_NEAR(tube.bounds().lo.x, -2.0, 1e-9);
  EXPECT_NEAR(tube.bounds().hi.z, 2.0, 1e-9);
  EXPECT_EQ(tube.bounds().hi.y, kGeometryShapesInf);
  const Quadric bowl(Vec3{1, 0, 1}, {}, {0, -1, 0}, 0.0);  // y = x2 + z2
  EXPECT_NEAR(bowl.bounds().lo.y, 0.0, 1e-9);
  EXPECT_EQ(bowl.bounds().hi.y, kGeometryShapesInf);
  const Quadric hollow(Vec3{-1, -1, -1}, {}, {}, 1.0);
  EXPECT_TRUE(hollow.traits().solid_is_unbounded);
  EXPECT_TRUE(hollow.inside({5, 0, 0}));
  ShapeHit hit;
  ASSERT_TRUE(bowl.nearest({{0, 5, 0}, {0, -1, 0}}, 0, kGeometryShapesInf, hit));
  EXPECT_NEAR(hit.t, 5.0, 1e-12);
  EXPECT_EQ(Quadric(std::array<double, 10>{1, 0, 1, 0, 0, 0, 0, 0, 0, -4}).bounds().lo.x,
            tube.bounds().lo.x);
}

TEST(UnitCoreSphere, UvFollowsTheObjectThroughTurns) {
  const Leaf plain(std::make_unique<Sphere>(Vec3{}, 1.0), Transform());
  const Transform turn = Transform::rotation({20, 50, 70}).then(Transform::translation({1, 2, 3}));
  const Leaf turned(std::make_unique<Sphere>(Vec3{}, 1.0), turn);
  Random random(14);
  for (int k = 0; k < 100; ++k) {
    const Vec3 p = random.direction();
    const Vec2 a = plain.uv(p, {}), b = turned.uv(turn.point(p), {});
    EXPECT_NEAR(a.u, b.u, 1e-9);
    EXPECT_NEAR(a.v, b.v, 1e-9);
  }
  EXPECT_DOUBLE_EQ(plain.uv({0, 0, 1}, {}).u, 0.25);
  EXPECT_DOUBLE_EQ(plain.uv({1, 0, 0}, {}).v, 0.5);
}

}  // namespace
}  // namespace lentray::core
