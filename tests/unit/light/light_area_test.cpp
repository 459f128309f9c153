#include "core/light/area_light.h"

#include <gtest/gtest.h>

#include <set>

using namespace lentray::core;

namespace {

AreaLight grid(int n, int m, int adaptive) {
  AreaLight area;
  area.axis1 = {4, 0, 0};
  area.axis2 = {0, 0, 2};
  area.size1 = n;
  area.size2 = m;
  area.adaptive = adaptive;
  return area;
}

struct Result {
  Rgb colour;
  std::multiset<std::uint32_t> samples;
};

template <class Shade>
Result sample(const AreaLight& area, Shade shade) {
  Result result;
  AreaScratch scratch;
  auto probe = [&](const Vec3& offset, std::uint32_t index) {
    result.samples.insert(index);
    return Rgb(shade(offset));
  };
  auto random = [] { return 0.5; };
  const AreaAxes axes = area_axes(area, {0, 1, 0});
  result.colour = AreaSampler(area, axes, scratch, probe, random).colour();
  return result;
}

TEST(UnitCoreAreaLight, UniformLightIsSampledAtTheCornersAlone) {
  const Result r = sample(grid(9, 9, 0), [](const Vec3&) { return 1.0f; });
  EXPECT_EQ(r.samples.size(), 4u);
  EXPECT_FLOAT_EQ(r.colour.r, 1.0f);
}

TEST(UnitCoreAreaLight, EveryAdaptiveLevelSplitsOnce) {
  const Result r = sample(grid(9, 9, 1), [](const Vec3&) { return 1.0f; });
  EXPECT_EQ(r.samples.size(), 9u) << "the corners of four quarters that share them";
  EXPECT_EQ(sample(grid(9, 9, 2), [](const Vec3&) { return 1.0f; }).samples.size(), 25u);
}

TEST(UnitCoreAreaLight, WithoutAdaptiveEverySampleIsAskedOnce) {
  const Result r = sample(grid(5, 4, -1), [](const Vec3&) { return 1.0f; });
  EXPECT_EQ(r.samples.size(), 20u);
  EXPECT_EQ(std::set<std::uint32_t>(r.samples.begin(), r.samples.end()).size(), 20u);
}

TEST(UnitCoreAreaLight, SplitsWhereTheCornersDiffer) {
  // Lit from x = -2 to -1 of -2 .. 2: columns 0, 1 and 2 of 0 .. 8.
  const Result r = sample(grid(9, 2, 0), [](const Vec3& at) { return at.x <= -1.0 ? 1.0f : 0.0f; });
  EXPECT_GT(r.samples.size(), 4u);
  EXPECT_LT(r.samples.size(), 18u);
  // Halves 0-4 and 4-8: the first splits into 0-2 (lit) and 2-4, that into 2-3 (half) and 3-4.
  EXPECT_FLOAT_EQ(r.colour.r, 0.5f * (0.5f * (1.0f + 0.5f * (0.5f + 0.0f))));
}

TEST(UnitCoreAreaLight, SmallDifferencesDoNotSplit) {
  const Result r = sample(grid(9, 9, 0), [](const Vec3& at) { return at.x < 0.0 ? 0.53f : 0.5f; });
  EXPECT_EQ(r.samples.size(), 4u) << "0.09 over three channels";
}

TEST(UnitCoreAreaLight, OffsetsSpanTheAxes) {
  const AreaLight area = grid(5, 3, -1);
  const AreaAxes axes{area.axis1, area.axis2};
  EXPECT_EQ(area_offset(area, axes, 0, 0), Vec3(-2, 0, -1));
  EXPECT_EQ(area_offset(area, axes, 4, 2), Vec3(2, 0, 1));
  EXPECT_EQ(area_offset(grid(1, 1, 0), axes, 0, 0), Vec3(0, 0, 0));
}

TEST(UnitCoreAreaLight, CircleHasItsCornersOnTheRim) {
  AreaLight area = grid(5, 5, -1);
  area.circular = true;
  area.axis2 = {0, 0, 4};
  const AreaAxes axes{area.axis1, area.axis2};
  EXPECT_NEAR(length(area_offset(area, axes, 0, 0)), 2.0, 0.01);
  EXPECT_NEAR(length(area_offset(area, axes, 4, 2)), 2.0, 0.01);
  EXPECT_TRUE(is_finite(area_offset(area, axes, 2, 2)));
}

TEST(UnitCoreAreaLight, OrientFacesThePoint) {
  AreaLight area = grid(5, 5, -1);
  area.orient = true;
  const Vec3 towards = normalized(Vec3{1, 2, 3});
  const AreaAxes axes = area_axes(area, towards);
  EXPECT_NEAR(dot(axes.first, towards), 0.0, 1e-12);
  EXPECT_NEAR(dot(axes.second, towards), 0.0, 1e-12);
  EXPECT_NEAR(length(axes.first), 4.0, 1e-12);
  EXPECT_NEAR(length(axes.second), 4.0, 1e-12) << "squared by the first axis";
}

}  // namespace
