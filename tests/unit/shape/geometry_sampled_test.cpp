// Shapes that are found by walking: Julia fractals, parametric surfaces and isosurfaces.
#include <gtest/gtest.h>

#include "core/shape/isosurface.h"
#include "core/shape/julia_fractal.h"
#include "core/shape/julia_maps.h"
#include "core/shape/parametric.h"
#include "tests/unit/shape/geometry_help.h"

namespace lentray::core {
namespace {

using geometry_test::Random;
constexpr double kGeometrySampledInf = Bounds::kInf;

TEST(UnitCoreJulia, HitsLieOnTheSurfaceWithinTheBounds) {
  for (const bool hypercomplex : {false, true}) {
    JuliaSettings set;
    set.hypercomplex = hypercomplex;
    set.parameter = {-0.16, 0.16, 0.4, -0.3};
    set.slice = {0.1, 0.2, -0.3, 1.0};
    set.precision = 50.0;
    set.max_iteration = 8;
    const auto shape = make_julia_fractal(set);
    Random random(3);
    int met = 0;
    for (int round = 0; round < 500; ++round) {
      const Ray ray = random.ray(6.0, 0.8);
      ShapeHits hits;
      shape->all(ray, 0.0, kGeometrySampledInf, hits);
      ShapeHit first;
      ASSERT_EQ(shape->nearest(ray, 0.0, kGeometrySampledInf, first), !hits.empty());
      if (hits.empty()) continue;
      ++met;
      EXPECT_EQ(first.t, hits[0].t);
      EXPECT_TRUE(shape->bounds().contains(ray.at(first.t)));
      EXPECT_TRUE(shape->inside(ray.at(first.t)));
      EXPECT_FALSE(shape->inside(ray.at(first.t - 2e-7)));
    }
    EXPECT_GT(met, 100);
  }
}

/// Rays go on within the ball that the orbit of a point foresees, and do not ask there.
template <class F>
void expect_room(JuliaSettings set) {
  using Map = julia::FunctionMap<F>;
  static_assert(Map::kForesees);
  set.hypercomplex = true;
  set.max_iteration = 6;
  set.precision = 30.0;
  const Map map(set, F{});
  typename Map::Memory orbit(map);
  Random random(5);
  int asked = 0;
  double unused;
  for (int round = 0; round < 3000; ++round) {
    const Vec3 p = random.vector(2.0);
    if (!map.step(p, {1, 0, 0}, unused, orbit)) continue;
    const double room = map.room(orbit, 1e-3);
    if (!(room > 0.0)) continue;
    for (int i = 0; i < 20; ++i) {
      ++asked;
      const Vec3 q = p + normalized(random.vector(1.0)) * (room * (i < 10 ? 0.999 : 0.5));
      EXPECT_TRUE(map.step(q, {1, 0, 0}, unused, orbit)) << round;
    }
  }
  EXPECT_GT(asked, 2000);
}

TEST(UnitCoreJulia, WhatAnOrbitForeseesIsWithin) {
  JuliaSettings set;
  set.parameter = {-0.6, 0.2, 0.2, 0.1};
  expect_room<complex_functions::Exp>(set);
  set.parameter = {-0.16, 0.16, 0.4, -0.3};
  expect_room<complex_functions::Sin>(set);
}

TEST(UnitCoreJulia, QuaternionsHaveTwoFunctions) {
  JuliaSettings set;
  set.function = JuliaFunction::kExp;
  EXPECT_THROW(make_julia_fractal(set), std::invalid_argument);
}

/// x, y or z of a ball of radius 1.
struct SampledBall final : Function {
  explicit SampledBall(int axis_) : axis(axis_) {}
  int axis;
  std::size_t parameters() const override { return 2; }
  double evaluate(std::span<const double> a) const override {
    if (axis == 1) return std::cos(a[0]);
    return std::sin(a[0]) * (axis == 0 ? std::cos(a[1]) : std::sin(a[1]));
  }
};

TEST(UnitCoreParametric, BoundsAreTheSurfacesNotTheContainers) {
  ParametricSettings set;
  for (int axis = 0; axis < 3; ++axis) {
    set.functions[static_cast<std::size_t>(axis)] = std::make_shared<SampledBall>(axis);
  }
  set.hi = {3.14159265358979, 6.28318530717959};
  set.box_lo = Vec3(-5.0);
  set.box_hi = Vec3(5.0);
  const Parametric ball(set);
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_GT(ball.bounds().lo[axis], -1.15);
    EXPECT_LT(ball.bounds().hi[axis], 1.15);
  }
  Random random(4);
  for (int round = 0; round < 200; ++round) {
    const Ray ray = random.ray(4.0, 0.5);
    ShapeHit hit;
    ASSERT_TRUE(ball.nearest(ray, 0.0, kGeometrySampledInf, hit));
    // A ray that runs along a range meets it early: its hit's point of the surface is what holds.
    const double where[] = {hit.u, hit.v};
    Vec3 p;
    for (int axis = 0; axis < 3; ++axis) p[axis] = SampledBall(axis).evaluate(where);
    EXPECT_LT(length(cross(p - ray.origin, ray.direction)), 0.02);
    EXPECT_TRUE(ball.bounds().contains(p));
    EXPECT_GT(std::fabs(dot(normalized(ball.normal(p, hit)), p)), 0.99);
    EXPECT_FALSE(ball.inside(p));
  }
}

TEST(UnitCoreParametric, RaysThatHardlyMoveAlongAnAxisHit) {
  ParametricSettings set;
  for (int axis = 0; axis < 3; ++axis) {
    set.functions[static_cast<std::size_t>(axis)] = std::make_shared<SampledBall>(axis);
  }
  set.hi = {3.14159265358979, 6.28318530717959};
  set.box_lo = Vec3(-1.5);
  set.box_hi = Vec3(1.5);
  set.accuracy = 0.01;
  const Parametric ball(set);
  for (const double slope : {0.0, 1e-11, 1e-9, 1e-6, 1e-4, 1e-2}) {
    for (const Vec3& along : {Vec3(-1, 1, 1), Vec3(1, -1, 1), Vec3(1, 1, -1)}) {
      for (int forwards = 0; forwards < 3; ++forwards) {
        Ray ray;
        for (int axis = 0; axis < 3; ++axis) {
          ray.direction[axis] = axis == forwards ? -1.0 : along[axis] * slope;
          ray.origin[axis] = axis == forwards ? 4.0 : 0.2 + 0.1 * axis;
        }
        ShapeHit hit;
        ASSERT_TRUE(ball.nearest(ray, 0.0, kGeometrySampledInf, hit))
            << slope << " along axis " << forwards;
        EXPECT_NEAR(length(ray.at(hit.t)), 1.0, 0.04) << slope << " along axis " << forwards;
      }
    }
  }
}

/// Rays in the space of a shape that is scaled to a millionth have such directions.
void expect_hits_with_long_directions(const Shape& shape) {
  constexpr double kLong = 1e6;
  Random random(5);
  for (int round = 0; round < 200; ++round) {
    const Ray ray = random.ray(4.0, 0.5);
    ShapeHit plain, scaled;
    ASSERT_TRUE(shape.nearest(ray, 0.0, kGeometrySampledInf, plain));
    ASSERT_TRUE(
        shape.nearest({ray.origin, ray.direction * kLong}, 0.0, kGeometrySampledInf, scaled));
    EXPECT_NEAR(scaled.t * kLong, plain.t, 0.05);
  }
}

TEST(UnitCoreParametric, ScaledDownItDoesNotVanish) {
  ParametricSettings set;
  for (int axis = 0; axis < 3; ++axis) {
    set.functions[static_cast<std::size_t>(axis)] = std::make_shared<SampledBall>(axis);
  }
  set.hi = {3.14159265358979, 6.28318530717959};
  set.box_lo = Vec3(-1.1);
  set.box_hi = Vec3(1.1);
  expect_hits_with_long_directions(Parametric(set));
}

struct Distance final : Function {
  std::size_t parameters() const override { return 3; }
  double evaluate(std::span<const double> a) const override {
    return std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]) - 1.0;
  }
};

TEST(UnitCoreIsosurface, ScaledDownItDoesNotVanish) {
  IsosurfaceSettings set;
  set.function = std::make_shared<Distance>();
  set.lo = Vec3(-1.1);
  set.hi = Vec3(1.1);
  expect_hits_with_long_directions(Isosurface(set));
  set.in_sphere = true;
  set.radius = 1.2;
  expect_hits_with_long_directions(Isosurface(set));
}

}  // namespace
}  // namespace lentray::core
