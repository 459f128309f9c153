// Which photons are shot: units of lights and targets, their spacing, rings and random numbers.
#include "core/photon/units.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "core/photon/rings.h"

namespace lentray::core {
namespace {

constexpr double kPi = std::numbers::pi;

PhotonTarget ball(const Vec3& centre, double radius) {
  PhotonTarget target;
  target.centre = centre;
  target.radius = radius;
  target.refraction = true;
  return target;
}

Light lamp(const Vec3& position, bool parallel = false) {
  Light light;
  light.position = position;
  light.parallel = parallel;
  light.direction = normalized(-position);
  return light;
}

std::vector<RingPart> parts_of(const PhotonUnit& unit, bool parallel, std::uint64_t draw = 0) {
  static const PhotonCycle kCycle;
  RingCutter cutter(unit, parallel, kCycle, draw);
  std::vector<RingPart> parts;
  while (const auto part = cutter.next()) parts.push_back(*part);
  return parts;
}

TEST(UnitPhotonUnits, WhatOneForbidsTheOtherCannotWant) {
  using Said = std::optional<bool>;
  EXPECT_TRUE(photons_go_on(true, Said()));
  EXPECT_TRUE(photons_go_on(Said(), true));
  EXPECT_FALSE(photons_go_on(true, false));
  EXPECT_FALSE(photons_go_on(false, true));
  EXPECT_FALSE(photons_go_on(Said(), Said()));
}

TEST(UnitPhotonUnits, EachLightShootsAtEachTarget) {
  std::vector<Light> lights{lamp({0, 10, 0}), lamp({0, 20, 0}), lamp({0, 5, 0}), lamp({0, 6, 0})};
  lights[1].shadowless = true;
  lights[2].grouped = true;
  lights[3].photon_refraction = false;
  std::vector<PhotonTarget> targets{ball({}, 1.0), ball({0, -10, 0}, 2.0)};
  targets[1].factor = 3.0;
  targets.push_back(ball({1, 0, 0}, 1.0));
  targets[2].refraction = false;
  const auto units = photon_units(lights, targets, 0.1);
  ASSERT_EQ(units.size(), 2u);
  EXPECT_EQ(units[0].target, 0u);
  EXPECT_DOUBLE_EQ(units[0].spread, 0.01);
  EXPECT_DOUBLE_EQ(units[0].step, std::atan(0.01));
  EXPECT_DOUBLE_EQ(units[0].end, std::asin(0.1));
  EXPECT_EQ(units[1].target, 1u);
  EXPECT_DOUBLE_EQ(units[1].spread, 0.3 / 20.0);
}

TEST(UnitPhotonUnits, ParallelLightsCountInLengthsAndLightsWithinShootAllAround) {
  const std::vector<Light> lights{lamp({0, 10, 0}, true), lamp({0, 0.5, 0})};
  const std::vector<PhotonTarget> targets{ball({}, 1.0)};
  const auto units = photon_units(lights, targets, 0.1);
  ASSERT_EQ(units.size(), 2u);
  EXPECT_EQ(units[0].step, 0.1);
  EXPECT_EQ(units[0].end, 1.0);
  EXPECT_EQ(units[1].end, kPi);
}

TEST(UnitPhotonUnits, ACountBecomesASpacing) {
  const std::vector<Light> lights{lamp({0, 10, 0})};
  std::vector<PhotonTarget> targets{ball({}, 1.0)};
  PhotonSettings settings;
  EXPECT_EQ(photon_spacing(lights, targets, settings), 1.0);
  settings.count = 1000;
  EXPECT_DOUBLE_EQ(photon_spacing(lights, targets, settings), std::sqrt(kPi / 1000.0));
  targets[0].reflection = true;
  EXPECT_DOUBLE_EQ(photon_spacing(lights, targets, settings), std::sqrt(kPi * 2.25 / 1000.0));
  targets[0].collects = false;
  EXPECT_DOUBLE_EQ(photon_spacing(lights, targets, settings), std::sqrt(kPi * 0.75 / 1000.0));
}

TEST(UnitPhotonUnits, AreaLightsShootFromAllPointsFartherApart) {
  Light light = lamp({0, 10, 0});
  light.has_area = light.photon_area = true;
  light.area.size1 = 3;
  light.area.size2 = 12;
  EXPECT_EQ(photons_at_once(light), 36);
  const auto units = photon_units(std::vector{light}, std::vector{ball({}, 1.0)}, 0.1);
  EXPECT_DOUBLE_EQ(units.at(0).spread, 0.06);
  light.parallel = true;
  EXPECT_EQ(photons_at_once(light), 1);
}

TEST(UnitPhotonUnits, RaysGoAroundTheWayToTheMiddle) {
  const Light light = lamp({0, 10, 0});
  for (const double turn : {-2.0, 0.0, 1.0}) {
    const Ray ray = photon_ray(light, light.position, {0, 0, 0}, 0.2, turn);
    EXPECT_NEAR(length(ray.direction), 1.0, 1e-15);
    EXPECT_NEAR(dot(ray.direction, Vec3(0, -1, 0)), std::cos(0.2), 1e-15);
    const Ray beside = photon_ray(lamp({0, 10, 0}, true), {0, 10, 0}, {3, 0, 0}, 0.2, turn);
    EXPECT_EQ(beside.direction, Vec3(0, -1, 0));
    EXPECT_NEAR(length(beside.origin - Vec3(3, 10, 0)), 0.2, 1e-15);
  }
}

TEST(UnitPhotonRings, PartsTakeTheCycleInOrder) {
  const PhotonUnit unit{0, 0, 0.002, 0.002, 0.1};
  const auto parts = parts_of(unit, true, 100);
  std::uint64_t draw = 100, photons = 0, rings = 0;
  bool begins = true;
  for (const RingPart& part : parts) {
    if (begins) ++draw;  // the ring's own
    EXPECT_EQ(part.draw, draw);
    EXPECT_LE(part.size, RingCutter::kMost);
    draw = part.next_draw();
    photons += part.size;
    rings += part.ends_ring ? 1 : 0;
    begins = part.ends_ring;
  }
  EXPECT_TRUE(parts.back().ends_ring);
  EXPECT_EQ(rings, 50u);
  EXPECT_GT(parts.size(), rings);  // the outer ones are cut
  const double expected = kPi * 50.0 * 50.0;
  EXPECT_NEAR(static_cast<double>(photons), expected, 0.03 * expected);
  const std::vector<Light> lights{lamp({0, 10, 0}, true)};
  EXPECT_NEAR(expected_photons(lights, std::vector{unit}), expected, 1e-6);
}

TEST(UnitPhotonRings, JitterMovesByAShareOfAStep) {
  const PhotonCycle cycle;
  const RingPart part{1.0, 0.5, 0.1, 4, true, 7};
  const RingPlace still = jittered(part, 0.5, 0.2, 0.0, cycle, 7);
  EXPECT_EQ(still.out, 1.0);
  EXPECT_EQ(still.turn, 0.5);
  const RingPlace moved = jittered(part, 0.5, 0.2, 1.0, cycle, 7);
  EXPECT_DOUBLE_EQ(moved.turn, 0.5 + 0.1 * (cycle.at(7) - 0.5));
  EXPECT_DOUBLE_EQ(moved.out, 1.0 + 0.2 * (cycle.at(8) - 0.5));
  EXPECT_EQ(cycle.at(3), cycle.at(3 + 32768));
}

}  // namespace
}  // namespace lentray::core
