// Which part of a ray a light reaches: the ends against a search along the ray.
#include "core/light/lit_part.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/light/light_ray.h"

namespace lentray::core::test {
namespace {

constexpr double kLength = 20.0;

Light lit_part_spot(double degrees) {
  Light light;
  light.kind = Light::Kind::kSpot;
  light.position = {1, 3, -2};
  light.direction = normalized(Vec3{-0.3, -1, 0.4});
  light.point_at = light.position + light.direction;
  light.colour = Rgb(1.0f);
  light.falloff = light.radius = std::cos(degrees * 3.14159265358979 / 180.0);
  return light;
}

Light cylinder(double radius) {
  Light light = lit_part_spot(10.0);
  light.kind = Light::Kind::kCylinder;
  light.radius = light.falloff = radius;
  return light;
}

/// Every place of the ray that gets light lies in the part, and its ends lie where light ends.
void expect_part(const Light& light, const Ray& ray) {
  const auto part = lit_part(light, ray, kLength);
  constexpr int kSteps = 4000;
  constexpr double kSlack = 2.0 * kLength / kSteps;
  double first = kLength, last = 0.0;
  for (int i = 1; i < kSteps; ++i) {
    const double t = kLength * i / kSteps;
    const Vec3 place = ray.at(t);
    if (!(light_attenuation(light, place, light_ray(light, place)) > 0.0)) continue;
    ASSERT_TRUE(part && t > part->from - 1e-9 && t < part->to + 1e-9) << t;
    first = std::min(first, t);
    last = std::max(last, t);
  }
  if (!part || first > last) return;
  EXPECT_NEAR(part->to, last, kSlack);
  // A cylinder's part begins at the ray's origin where the ray comes from behind the light.
  if (part->from > 0.0) {
    EXPECT_NEAR(part->from, first, kSlack);
  }
}

TEST(UnitLitPart, HoldsAllThatIsLitAndEndsThere) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-6.0, 6.0), way(-1.0, 1.0);
  for (int i = 0; i < 400; ++i) {
    const Ray ray{{place(random), place(random), place(random)},
                  normalized(Vec3{way(random), way(random), way(random)})};
    for (const double degrees : {3.0, 20.0, 50.0}) expect_part(lit_part_spot(degrees), ray);
    for (const double radius : {0.2, 1.5}) expect_part(cylinder(radius), ray);
  }
}

TEST(UnitLitPart, PointLightsReachAllAndFillLightsNothing) {
  Light light;
  const Ray ray{{0, 0, 0}, {0, 0, 1}};
  const auto part = lit_part(light, ray, 7.0);
  ASSERT_TRUE(part);
  EXPECT_EQ(part->from, 0.0);
  EXPECT_EQ(part->to, 7.0);
  light.shadowless = true;
  EXPECT_FALSE(lit_part(light, ray, 7.0));
}

TEST(UnitLitPart, ARayAlongACylindersAxisIsLitAllTheWay) {
  const Light light = cylinder(0.5);
  const auto part = lit_part(light, {light.position + light.direction, light.direction}, 5.0);
  ASSERT_TRUE(part);
  EXPECT_EQ(part->from, 0.0);
  EXPECT_EQ(part->to, 5.0);
}

}  // namespace
}  // namespace lentray::core::test
