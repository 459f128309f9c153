// How a translucent solid scatters light: the table of albedos, the dipole against its integral, directions.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

#include "core/subsurface/dipole.h"
#include "core/subsurface/directions.h"
#include "core/subsurface/scattering.h"

namespace lentray::core::test {
namespace {

TEST(UnitSubsurface, AlbedoIsTheOneThatReflects) {
  for (const double ior : {0.8, 1.0, 1.3, 1.5, 2.5}) {
    const ReducedAlbedo albedo(ior);
    for (int hundredth = 1; hundredth < 100; ++hundredth) {
      const double wanted = hundredth / 100.0;
      EXPECT_NEAR(diffuse_reflectance(boundary_factor(ior), albedo.at(wanted)), wanted, 1e-12)
          << ior;
    }
    EXPECT_EQ(albedo.at(0.0), 0.0);
    EXPECT_EQ(albedo.at(-1.0), 0.0);
    EXPECT_EQ(albedo.at(1.0), 1.0);
    EXPECT_EQ(albedo.at(3.0), 1.0);
    EXPECT_NEAR(albedo.at(0.345), (albedo.at(0.34) + albedo.at(0.35)) / 2.0, 1e-12);
  }
}

TEST(UnitSubsurface, DiffuseLightIsThrownBackMoreByDenserSolids) {
  EXPECT_EQ(diffuse_fresnel_reflectance(1.0), 0.0);
  EXPECT_EQ(boundary_factor(1.0), 1.0);
  const double glass = diffuse_fresnel_reflectance(1.5);
  EXPECT_NEAR(glass, (1.0 / 3.0 + 3.0 * std::pow(1.0 / 3.0, 4.5)) / 4.0, 1e-15);
  EXPECT_GT(diffuse_fresnel_reflectance(2.0), glass);
  EXPECT_LT(diffuse_fresnel_reflectance(50.0), 1.0);
}

/// Over an endless flat surface the dipole gives what the solid throws back: a closed form.
TEST(UnitSubsurface, DipoleGivesTheReflectanceOfAnEndlessPlane) {
  for (const double albedo : {0.2, 0.8, 0.99}) {
    const double factor = boundary_factor(1.4), lost = 2.5;
    const Dipole dipole(albedo * lost, lost, factor);
    // r = e^x, so that dr = r dx: all of it from 1e-6 to 1e4 mm.
    constexpr int kSteps = 20'000;
    const double from = std::log(1e-6), step = (std::log(1e4) - from) / kSteps;
    double sum = 0.0;
    for (int i = 0; i < kSteps; ++i) {
      const double r = std::exp(from + (i + 0.5) * step);
      sum += 2.0 * std::numbers::pi * r * r * step * dipole.at(r * r);
    }
    EXPECT_NEAR(sum, diffuse_reflectance(factor, albedo), 1e-6) << albedo;
  }
}

TEST(UnitSubsurface, DipoleWithoutAbsorptionFallsWithTheCube) {
  const Dipole dipole(1.0, 1.0, 1.0);
  EXPECT_NEAR(dipole.at(1e8) / dipole.at(4e8), 8.0, 1e-3);
  EXPECT_EQ(Dipole().at(1.0), 0.0);
}

TEST(UnitSubsurface, BlackChannelsDoNotCount) {
  const ReducedAlbedo albedo(1.3);
  const Scattering some = scattering_of(albedo, {0.5f, 0.0f, 0.5f}, {2.0f, 1.0f, 2.0f});
  EXPECT_EQ(some.scattered[0], 0.5);
  EXPECT_EQ(some.lost[0], 0.5 / albedo.at(0.5));
  EXPECT_EQ(some.lost[1], 0.0);
  EXPECT_NEAR(some.mean_lost, some.lost[0], 1e-15);
  EXPECT_EQ(scattering_of(albedo, Rgb(0.0f), Rgb(1.0f)).mean_lost, 0.0);
  const Scattering all = scattering_of(albedo, {0.5f, 0.25f, 0.75f}, {2.0f, 1.0f, 4.0f});
  EXPECT_NEAR(all.mean_lost, 0.297 * all.lost[0] + 0.589 * all.lost[1] + 0.114 * all.lost[2],
              1e-15);
}

TEST(UnitSubsurface, DirectionsAreEven) {
  constexpr int kCount = 400;
  SphereDirections directions(kCount, {0.3, 0.7});
  Vec3 sum;
  int octants[8] = {};
  for (int i = 0; i < kCount; ++i) {
    const Vec3 d = directions.next();
    EXPECT_NEAR(length(d), 1.0, 1e-12);
    sum += d;
    ++octants[(d.x > 0.0) + 2 * (d.y > 0.0) + 4 * (d.z > 0.0)];
  }
  EXPECT_LT(length(sum), 0.02 * kCount);
  for (const int count : octants) EXPECT_NEAR(count, kCount / 8, 5);
  // A single one may go anywhere.
  EXPECT_NEAR(SphereDirections(1, {0.0, 0.0}).next().y, 1.0, 1e-12);
  EXPECT_NEAR(SphereDirections(1, {1.0, 0.0}).next().y, -1.0, 1e-12);
}

TEST(UnitSubsurface, SpiralsOfABlockBeginEverywhere) {
  // Of 8 x 8 pixels, one height in each 64th and one turn in each 27th part or two.
  std::set<int> heights;
  int turns[27] = {};
  for (std::uint32_t row = 16; row < 24; ++row) {
    for (std::uint32_t column = 40; column < 48; ++column) {
      const SpiralStart start = spiral_start(std::uint64_t{row} << 32 | column);
      heights.insert(static_cast<int>(start.height * 64.0));
      ++turns[static_cast<int>(start.turn * 27.0)];
    }
  }
  EXPECT_EQ(heights.size(), 64u);
  for (const int count : turns) {
    EXPECT_GE(count, 2);
    EXPECT_LE(count, 3);
  }
}

}  // namespace
}  // namespace lentray::core::test
