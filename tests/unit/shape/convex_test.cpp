// Convex solids as one closed set answer as the shapes do: the same crossings to the bit, and sides that agree
// with what the shape holds, for points and rays near, grazing, inside and far away.
#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <random>
#include <vector>

#include "core/shape/box.h"
#include "core/shape/cone.h"
#include "core/shape/convex.h"
#include "core/shape/cylinder.h"
#include "core/shape/plane.h"
#include "core/shape/sphere.h"

namespace lentray::core {
namespace {

std::vector<std::unique_ptr<Shape>> convex_shapes(double size) {
  std::vector<std::unique_ptr<Shape>> shapes;
  const auto at = [&](double x, double y, double z) { return Vec3{x, y, z} * size; };
  shapes.push_back(std::make_unique<Box>(at(-1, -0.5, 0), at(1, 0.5, 0.01)));
  shapes.push_back(std::make_unique<Sphere>(at(0.2, 0, 0), 0.7 * size));
  shapes.push_back(std::make_unique<Plane>(Vec3{1, 2, 0}, 0.3 * size));
  shapes.push_back(std::make_unique<Cone>(at(0, -1, 0), 0.8 * size, at(0, 1, 0.2), 0.0));
  shapes.push_back(std::make_unique<Cone>(at(0, 0, 0), 0.9 * size, at(0.05, 0, 0), 0.1 * size));
  shapes.push_back(std::make_unique<Cylinder>(at(-1, 0, 0), at(1, 0, 0), 0.5 * size));
  return shapes;
}

class UnitShapeConvex : public ::testing::TestWithParam<double> {};

TEST_P(UnitShapeConvex, SidesAgreeWithWhatTheShapeHolds) {
  const double size = GetParam(), margin = 1e-6 * 3.0 * size;
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  const auto point = [&] { return Vec3{normal(random), normal(random), normal(random)} * size; };
  for (const auto& shape : convex_shapes(size)) {
    ASSERT_TRUE(Convex::holds(*shape));
    const Convex convex(*shape, margin);
    int clear = 0;
    for (int i = 0; i < 20000; ++i) {
      Vec3 p = point();
      ShapeHit hit;
      // Every other one is moved to the surface, and a little away from it.
      const Ray to_surface{p, point() - p};
      if (i % 2 == 0 && shape->nearest(to_surface, -10.0, 10.0, hit)) {
        p = to_surface.at(hit.t) + point() * (i % 4 == 0 ? 0.0 : 2e-6);
        if (i % 4 == 0) {
          ASSERT_EQ(convex.side(p), Side::kNear) << shape->name() << i;
        }
      }
      const Side side = convex.side(p);
      if (side == Side::kNear) continue;
      ++clear;
      const Vec3 other = p + point() * (0.1 * margin / size);
      for (const Vec3& q : {p, other}) {
        ASSERT_EQ(shape->holds(q, false), side == Side::kInside) << shape->name() << i;
        ASSERT_EQ(shape->holds(q, true), side == Side::kOutside) << shape->name() << i;
      }
    }
    EXPECT_GT(clear, 10000) << shape->name();
  }
}

TEST_P(UnitShapeConvex, CrossingsAreTheShapes) {
  const double size = GetParam();
  std::mt19937 random(4);
  std::normal_distribution<double> normal;
  const auto point = [&] { return Vec3{normal(random), normal(random), normal(random)} * size; };
  for (const auto& shape : convex_shapes(size)) {
    const Convex convex(*shape, 1e-6 * size);
    int met = 0;
    for (int i = 0; i < 20000; ++i) {
      const Vec3 from = point() * (i % 3 == 0 ? 0.3 : i % 3 == 1 ? 3.0 : 1e7);
      Vec3 to = point() * 0.5;
      if (i % 5 == 0) to.x = from.x;  // along faces and axes
      if (i % 10 == 0) to.z = from.z;
      const Ray ray{from, normalized(to - from)};
      const double t_min = i % 4 == 0 ? 0.5 * size : 0.0;
      ShapeHits expected;
      shape->all(ray, t_min, Bounds::kInf, expected);
      std::array<Crossing, 2> found;
      const int count = convex.crossings(ray, t_min, found.data());
      std::size_t next = 0;
      for (int k = 0; k < count; ++k) {
        const Crossing& one = found[static_cast<std::size_t>(k)];
        if (!(one.t > t_min && one.t < Bounds::kInf)) continue;
        ASSERT_LT(next, expected.size()) << shape->name() << i;
        ASSERT_EQ(one.t, expected[next].t) << shape->name() << i;
        ASSERT_EQ(one.element, expected[next].element) << shape->name() << i;
        ++next;
      }
      ASSERT_EQ(next, expected.size()) << shape->name() << i;
      met += next > 0;
    }
    EXPECT_GT(met, 1000) << shape->name();
  }
}

TEST(UnitShapeConvexSet, LeavesOutOpenShapes) {
  EXPECT_FALSE(Convex::holds(Cylinder({0, 0, 0}, {0, 1, 0}, 1.0, true)));
  EXPECT_FALSE(Convex::holds(Cone({0, 0, 0}, 1.0, {0, 1, 0}, 0.5, true)));
}

INSTANTIATE_TEST_SUITE_P(Sizes, UnitShapeConvex, ::testing::Values(1.0, 1e-3, 1e7));

}  // namespace
}  // namespace lentray::core
