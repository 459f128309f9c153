// Exponential, sine and cosine of pairs beside those of long doubles and, beyond their range, the system's.
#include "core/base/pair_math.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace lentray::core {
namespace {

/// In units of the last place of `truth`.
double error(double value, long double truth) {
  int exponent = 0;
  std::frexp(static_cast<double>(truth), &exponent);
  return static_cast<double>(
      std::fabs((static_cast<long double>(value) - truth) / std::ldexp(1.0L, exponent - 53)));
}

bool pair_math_same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

TEST(UnitCorePairMath, IsOffByLessThanOneUnit) {
  std::mt19937_64 random(1);
  for (const double range : {0.01, 1.0, 6.0, 100.0, 690.0, 9e4}) {
    std::uniform_real_distribution<double> number(-range, range);
    double worst = 0.0;
    for (int i = 0; i < 50000; ++i) {
      const Pair x{number(random), number(random)};
      const CosSin turn = cos_sin(x);
      for (int lane = 0; lane < 2; ++lane) {
        const long double at = x[lane];
        worst = std::max(
            {worst, error(turn.cos[lane], std::cos(at)), error(turn.sin[lane], std::sin(at))});
        if (range < 700.0) worst = std::max(worst, error(exp(x)[lane], std::exp(at)));
      }
    }
    EXPECT_LT(worst, 1.0) << range;
  }
}

TEST(UnitCorePairMath, NearMultiplesOfAQuarterTurnToo) {
  for (int i = -2000; i <= 2000; ++i) {
    const double x = i * (3.14159265358979323846 / 2);
    const CosSin turn = cos_sin(Pair{x, x + 1e-9});
    for (int lane = 0; lane < 2; ++lane) {
      const long double at = lane == 0 ? x : x + 1e-9;
      EXPECT_LT(error(turn.cos[lane], std::cos(at)), 1.0) << i;
      EXPECT_LT(error(turn.sin[lane], std::sin(at)), 1.0) << i;
    }
  }
}

TEST(UnitCorePairMath, BeyondItsRangeIsTheSystems) {
  const double inf = std::numeric_limits<double>::infinity(),
               nan = std::numeric_limits<double>::quiet_NaN();
  const Pair one = exp(Pair{1.0, 1.0});
  for (const double x : {701.0, 710.0, -701.0, -745.0, -1e9, 1e6, -1e6, 1e300, inf, -inf, nan}) {
    const Pair power = exp(Pair{x, 1.0});
    EXPECT_TRUE(pair_math_same(power[0], std::exp(x))) << x;
    EXPECT_EQ(power[1], one[1]) << x;  // a number does not depend on the one beside it
    if (std::fabs(x) <= 1e5) continue;
    const CosSin turn = cos_sin(Pair{1.0, x});
    EXPECT_TRUE(pair_math_same(turn.cos[1], std::cos(x)) &&
                pair_math_same(turn.sin[1], std::sin(x)))
        << x;
    EXPECT_EQ(turn.sin[0], cos_sin(Pair{1.0, 1.0}).sin[0]) << x;
  }
}

TEST(UnitCorePairMath, ZeroIsExact) {
  const CosSin turn = cos_sin(Pair{});
  EXPECT_EQ(turn.cos[0], 1.0);
  EXPECT_EQ(turn.sin[1], 0.0);
  EXPECT_EQ(exp(Pair{})[0], 1.0);
}

}  // namespace
}  // namespace lentray::core
