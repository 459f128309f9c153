#include "core/light/light_ray.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

using namespace lentray::core;

namespace {

double cos_deg(double degrees) { return std::cos(degrees * std::numbers::pi / 180.0); }

Light spot() {
  Light light;
  light.kind = Light::Kind::kSpot;
  light.position = {0, 10, 0};
  light.point_at = {0, 0, 0};
  light.direction = {0, -1, 0};
  light.colour = Rgb(1.0f);
  light.radius = cos_deg(10);
  light.falloff = cos_deg(20);
  return light;
}

double factor(const Light& light, const Vec3& from) {
  return light_attenuation(light, from, light_ray(light, from));
}

TEST(UnitCoreLightRay, PointLight) {
  Light light;
  light.position = {0, 3, 4};
  const LightRay ray = light_ray(light, {0, 0, 0});
  EXPECT_DOUBLE_EQ(ray.distance, 5.0);
  EXPECT_DOUBLE_EQ(ray.direction.y, 0.6);
  EXPECT_DOUBLE_EQ(factor(light, {0, 0, 0}), 1.0);
}

TEST(UnitCoreLightRay, SampleOffsetMovesTheLight) {
  Light light;
  light.position = {0, 3, 0};
  EXPECT_DOUBLE_EQ(light_ray(light, {0, 0, 0}, {0, 0, 4}).distance, 5.0);
}

TEST(UnitCoreLightRay, SpotIsFullInsideItsRadiusAndDarkBeyondFalloff) {
  const Light light = spot();
  EXPECT_DOUBLE_EQ(factor(light, {0, 0, 0}), 1.0);
  EXPECT_DOUBLE_EQ(factor(light, {10 * std::tan(0.99 * 10 * std::numbers::pi / 180), 0, 0}), 1.0);
  EXPECT_DOUBLE_EQ(factor(light, {10 * std::tan(20.1 * std::numbers::pi / 180), 0, 0}), 0.0);
  EXPECT_DOUBLE_EQ(factor(light, {0, 20, 0}), 0.0) << "behind the spotlight";
}

TEST(UnitCoreLightRay, SpotEdgeIsTheCubic) {
  const Light light = spot();
  const double tangent = std::tan(15 * std::numbers::pi / 180);
  const double s = (cos_deg(15) - light.falloff) / (light.radius - light.falloff);
  EXPECT_NEAR(factor(light, {10 * tangent, 0, 0}), s * s * (3 - 2 * s), 1e-12);
}

TEST(UnitCoreLightRay, TightnessIsAPowerOfTheCosine) {
  Light light = spot();
  light.tightness = 7;
  const double angle = 5 * std::numbers::pi / 180;
  EXPECT_NEAR(factor(light, {10 * std::tan(angle), 0, 0}), std::pow(std::cos(angle), 7), 1e-12);
}

TEST(UnitCoreLightRay, CylinderShinesAlongItsAxis) {
  Light light = spot();
  light.kind = Light::Kind::kCylinder;
  light.parallel = true;
  light.radius = 1.0;
  light.falloff = 2.0;
  const LightRay ray = light_ray(light, {0.5, 2, 0});
  EXPECT_DOUBLE_EQ(ray.direction.y, 1.0);
  EXPECT_DOUBLE_EQ(ray.distance, 8.0);
  EXPECT_DOUBLE_EQ(factor(light, {0.5, 2, 0}), 1.0);
  EXPECT_DOUBLE_EQ(factor(light, {2.1, 2, 0}), 0.0);
  EXPECT_DOUBLE_EQ(factor(light, {0.5, 12, 0}), 0.0) << "behind the light";
  // 1 - 1.5 / 2 = 0.25 of 1 - 1 / 2 = 0.5: the middle of the edge.
  EXPECT_NEAR(factor(light, {1.5, 2, 0}), 0.5, 1e-12);
}

TEST(UnitCoreLightRay, ParallelRaysShareOneDirection) {
  Light light = spot();
  light.kind = Light::Kind::kPoint;
  light.parallel = true;
  const LightRay ray = light_ray(light, {30, 2, 5});
  EXPECT_DOUBLE_EQ(ray.direction.y, 1.0);
  EXPECT_NEAR(ray.distance, 8.0, 1e-12);
  EXPECT_LT(light_ray(light, {0, 11, 0}).distance, 0.0) << "behind its plane";
}

TEST(UnitCoreLightRay, FadingHalvesAtItsDistanceFromTwice) {
  Light light;
  light.position = {0, 10, 0};
  light.fade_distance = 10;
  light.fade_power = 2;
  EXPECT_DOUBLE_EQ(factor(light, {0, 0, 0}), 1.0);
  EXPECT_NEAR(factor(light, {0, -10, 0}), 2.0 / 5.0, 1e-12);
}

}  // namespace
