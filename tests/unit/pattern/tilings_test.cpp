// Tilings: levels, periods, symmetries. Their values are compared with stock by tests/image/tilings_test.cpp.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/pattern/tile_plans.h"
#include "core/pattern/tiling.h"

namespace lentray::core {
namespace {

std::vector<Vec3> tilings_points(double reach, int count = 3000) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> place(-reach, reach);
  std::vector<Vec3> all;
  for (int i = 0; i < count; ++i) all.push_back({place(random), place(random), place(random)});
  return all;
}

TilePlan plan_of(int number) {
  for (const int n : {1, 6, 10, 11, 12, 13, 14, 15, 18}) {
    if (number == n) return plan_of_squares(number);
  }
  return plan_of_polygons(number);
}

double cross(PlanePoint a, PlanePoint b) { return a.x * b.z - a.z * b.x; }

double area(const Tile& tile) {
  double twice = 0.0;
  for (std::size_t i = 0; i < tile.corners.size(); ++i) {
    twice += cross(tile.corners[i], tile.corners[(i + 1) % tile.corners.size()]);
  }
  return std::fabs(twice) / 2.0;
}

int levels_of(int number) {
  if (number == 25) return 6;
  return number > 25 ? 2 : plan_of(number).levels;
}

class UnitTilings : public ::testing::TestWithParam<int> {};
class UnitPeriodicTilings : public ::testing::TestWithParam<int> {};
class UnitGoldenTilings : public ::testing::TestWithParam<int> {};

TEST_P(UnitTilings, ValuesReachFromZeroToOneAndTouchEveryLevel) {
  const PatternPtr tiling = make_tiling(GetParam());
  const int levels = levels_of(GetParam());
  std::vector<int> seen(levels, 0);
  for (const double reach : {1.0, 12.0, 1e4}) {
    for (const Vec3& p : tilings_points(reach)) {
      const double value = tiling->value(p);
      ASSERT_GE(value, 0.0);
      ASSERT_LE(value, 1.0);
      ++seen[std::min(static_cast<int>(value * levels), levels - 1)];
    }
  }
  for (int level = 0; level < levels; ++level) EXPECT_GT(seen[level], 0) << "level " << level;
}

TEST_P(UnitTilings, HeightDoesNotMatter) {
  const PatternPtr tiling = make_tiling(GetParam());
  for (const Vec3& p : tilings_points(9.0, 300)) {
    EXPECT_EQ(tiling->value(p), tiling->value({p.x, -3.5 * p.y, p.z}));
  }
}

/// Within a tile values change slowly: a step between near points is one between two levels' ends.
TEST_P(UnitTilings, NearPointsOfATileHaveNearValues) {
  const PatternPtr tiling = make_tiling(GetParam());
  const int levels = levels_of(GetParam());
  constexpr double kNear = 1e-6, kSteepest = 6.0;
  for (const Vec3& p : tilings_points(9.0)) {
    const double one = tiling->value(p), other = tiling->value({p.x + kNear, p.y, p.z});
    if (std::fabs(one - other) <= kNear * kSteepest) continue;
    // Both are at the upper end of their level, so at an edge.
    for (const double value : {one, other}) {
      const double scaled = value * levels;
      EXPECT_LT(std::ceil(scaled - 1e-9) - scaled, 1e-4) << p.x << ' ' << p.z;
    }
  }
}

TEST_P(UnitTilings, AnswerToWhatIsNoNumber) {
  const PatternPtr tiling = make_tiling(GetParam());
  const double infinite = std::numeric_limits<double>::infinity();
  for (const double odd : {infinite, -infinite, std::numeric_limits<double>::quiet_NaN(), 1e300}) {
    tiling->value({odd, 0, 0});
    tiling->value({0, 0, odd});
    tiling->value({odd, 0, odd});
  }
}

TEST_P(UnitPeriodicTilings, RepeatAlongBothSteps) {
  const PatternPtr tiling = make_tiling(GetParam());
  const TilePlan plan = plan_of(GetParam());
  for (const Vec3& p : tilings_points(5.0)) {
    const double here = tiling->value(p);
    if (here * plan.levels - std::floor(here * plan.levels) > 0.999) continue;  // at an edge
    for (const PlanePoint step : {plan.first_step, plan.second_step}) {
      EXPECT_NEAR(here, tiling->value({p.x + 7 * step.x, p.y, p.z + 7 * step.z}), 1e-9);
      EXPECT_NEAR(here, tiling->value({p.x - step.x, p.y, p.z - step.z}), 1e-9);
    }
  }
}

TEST_P(UnitPeriodicTilings, TilesFillAPeriod) {
  const TilePlan plan = plan_of(GetParam());
  double filled = 0.0;
  for (const Tile& tile : plan.tiles) filled += area(tile);
  EXPECT_NEAR(filled, std::fabs(cross(plan.first_step, plan.second_step)), 1e-12);
}

TEST_P(UnitPeriodicTilings, MiddlesHaveTheirLevelAndCornersTheNext) {
  const PatternPtr tiling = make_tiling(GetParam());
  const TilePlan plan = plan_of(GetParam());
  for (const Tile& tile : plan.tiles) {
    PlanePoint middle;
    for (const PlanePoint& c : tile.corners) {
      middle.x += c.x / static_cast<double>(tile.corners.size());
      middle.z += c.z / static_cast<double>(tile.corners.size());
    }
    const double low = static_cast<double>(tile.level) / plan.levels;
    const double at_middle = tiling->value({middle.x, 0, middle.z});
    EXPECT_GE(at_middle, low);
    EXPECT_LT(at_middle, low + 0.5 / plan.levels);
    for (const PlanePoint& c : tile.corners) {
      const double near = 1e-5;
      const Vec3 inside{c.x + near * (middle.x - c.x), 0, c.z + near * (middle.z - c.z)};
      EXPECT_NEAR(tiling->value(inside), low + 1.0 / plan.levels, 1e-4);
    }
  }
}

TEST_P(UnitGoldenTilings, HaveFiveAxesThroughTheOrigin) {
  const PatternPtr tiling = make_tiling(GetParam());
  const double cosine = std::cos(0.4 * std::numbers::pi), sine = std::sin(0.4 * std::numbers::pi);
  for (const Vec3& p : tilings_points(40.0)) {
    const double here = tiling->value(p);
    EXPECT_NEAR(here, tiling->value({p.x, p.y, -p.z}), 1e-9);
    EXPECT_NEAR(here, tiling->value({cosine * p.x - sine * p.z, p.y, sine * p.x + cosine * p.z}),
                1e-9);
  }
}

TEST(UnitTiling, NumbersEndAt27) {
  EXPECT_THROW(make_tiling(0), std::invalid_argument);
  EXPECT_THROW(make_tiling(28), std::invalid_argument);
}

/// Middles are a trace above their level: a colour map with a step there shows the step's upper side.
TEST(UnitTiling, FlatMiddlesAreAboveTheirLevel) {
  const PatternPtr tiling = make_tiling(7);
  EXPECT_GT(tiling->value({0, 0, 0}), 0.5);
  EXPECT_LT(tiling->value({0, 0, 0}), 0.5 + 1e-6);
}

const auto kName = [](const auto& named) { return "n" + std::to_string(named.param); };
INSTANTIATE_TEST_SUITE_P(Each, UnitTilings, ::testing::Range(1, 28), kName);
INSTANTIATE_TEST_SUITE_P(Each, UnitPeriodicTilings, ::testing::Range(1, 25), kName);
INSTANTIATE_TEST_SUITE_P(Each, UnitGoldenTilings, ::testing::Range(25, 28), kName);

}  // namespace
}  // namespace lentray::core
