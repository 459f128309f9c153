// Roots of polynomials against roots that are known beforehand.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/numeric/roots.h"
#include "tests/unit/shape/geometry_help.h"

namespace lentray::core {
namespace {

using geometry_test::Random;

void expand(const double* roots, int n, double* c) {
  std::fill(c, c + n + 1, 0.0);
  c[0] = 1.0;
  for (int i = 0; i < n; ++i) {
    for (int k = i + 1; k >= 1; --k) c[k] -= roots[i] * c[k - 1];
  }
}

int all_roots(const double* c, int order, double* found) {
  constexpr double kInf = std::numeric_limits<double>::infinity();
  return solve_between_bounds(c, order, -kInf, kInf, found);
}

TEST(UnitCoreRoots, QuadraticWithoutCancellation) {
  double r[2];
  ASSERT_EQ(solve_quadratic(1.0, -1e8, 1.0, r), 2);
  EXPECT_NEAR(r[0], 1e-8, 1e-23);
  EXPECT_NEAR(r[1], 1e8, 1e-7);
  EXPECT_EQ(solve_quadratic(0.0, 0.0, 1.0, r), 0);
  ASSERT_EQ(solve_quadratic(0.0, 2.0, -3.0, r), 1);
  EXPECT_DOUBLE_EQ(r[0], 1.5);
  EXPECT_EQ(solve_quadratic(1.0, 0.0, 1.0, r), 0);
  ASSERT_GE(solve_quadratic(1.0, -2.0, 1.0, r), 1);
  EXPECT_DOUBLE_EQ(r[0], 1.0);
}

TEST(UnitCoreRoots, CubicAndQuarticKnownRoots) {
  Random random(1);
  for (int round = 0; round < 20000; ++round) {
    const int n = 3 + round % 2;
    double known[4], c[5], found[4];
    for (int i = 0; i < n; ++i) known[i] = random.in(-10.0, 10.0);
    std::sort(known, known + n);
    double gap = 1e9;
    for (int i = 1; i < n; ++i) gap = std::min(gap, known[i] - known[i - 1]);
    if (gap < 1e-2) continue;
    expand(known, n, c);
    ASSERT_EQ(all_roots(c, n, found), n);
    for (int i = 0; i < n; ++i) EXPECT_NEAR(found[i], known[i], 1e-8);
  }
}

TEST(UnitCoreRoots, NearDoubleRoots) {
  // (x - 1)(x - 1 - h)(x + 2)(x - 4): the pair is found while rounding leaves it two roots.
  for (double h : {1e-2, 1e-4, 1e-6}) {
    const double known[4] = {-2.0, 1.0, 1.0 + h, 4.0};
    double c[5], found[4];
    expand(known, 4, c);
    ASSERT_EQ(all_roots(c, 4, found), 4) << h;
    for (int i = 0; i < 4; ++i) EXPECT_NEAR(found[i], known[i], 1e-14 / h);
  }
}

TEST(UnitCoreRoots, NoRootsAndLowerOrders) {
  double r[4];
  const double none[5] = {1, 0, 0, 0, 1};
  EXPECT_EQ(all_roots(none, 4, r), 0);
  const double lower[5] = {0, 0, 1, 0, -4};
  ASSERT_EQ(all_roots(lower, 4, r), 2);
  EXPECT_DOUBLE_EQ(r[0], -2.0);
  EXPECT_DOUBLE_EQ(r[1], 2.0);
  const double zero[5] = {0, 0, 0, 0, 0};
  EXPECT_EQ(all_roots(zero, 4, r), 0);
}

TEST(UnitCoreRoots, RootsOfManySizes) {
  // Newton steps from one size of roots to the next only crawl.
  for (int n = 5; n <= 13; ++n) {
    double known[16], c[17], found[17];
    for (int i = 0; i < n; ++i) known[i] = (i % 3 == 0 ? -1.0 : 1.0) * std::pow(10.0, i - n / 2);
    std::sort(known, known + n);
    expand(known, n, c);
    ASSERT_EQ(solve_between_bounds(c, n, -HUGE_VAL, HUGE_VAL, found), n);
    for (int i = 0; i < n; ++i) EXPECT_NEAR(found[i] / known[i], 1.0, 1e-11) << n;
  }
}

TEST(UnitCoreRoots, NarrowIntervals) {
  // Where the interval itself shows that there is no root, or one: the same roots as from afar.
  Random random(7);
  int met = 0;
  for (int round = 0; round < 5000; ++round) {
    const int n = random.whole(3, 9);
    double known[9], c[10], found[10];
    for (int i = 0; i < n; ++i) known[i] = random.in(-4.0, 4.0);
    std::sort(known, known + n);
    double gap = 1e9;
    for (int i = 1; i < n; ++i) gap = std::min(gap, known[i] - known[i - 1]);
    if (gap < 1e-2) continue;
    expand(known, n, c);
    const double lo = random.in(-4.0, 4.0), hi = lo + std::pow(10.0, random.in(-3.0, 0.5));
    const int expected = static_cast<int>(std::upper_bound(known, known + n, hi) -
                                          std::lower_bound(known, known + n, lo));
    ASSERT_EQ(solve_between(c, n, lo, hi, found), expected) << round;
    met += expected;
  }
  EXPECT_GT(met, 1000);
}

TEST(UnitCoreRoots, OnlyBetween) {
  const double known[4] = {-2.0, 1.0, 2.0, 4.0};
  double c[5], found[4];
  expand(known, 4, c);
  ASSERT_EQ(solve_between(c, 4, 0.0, 3.0, found), 2);
  EXPECT_NEAR(found[0], 1.0, 1e-14);
  EXPECT_NEAR(found[1], 2.0, 1e-14);
  ASSERT_GE(solve_between(c, 4, 0.0, 3.0, found, true), 1);
  EXPECT_NEAR(found[0], 1.0, 1e-14);
  EXPECT_EQ(solve_between(c, 4, 5.0, 9.0, found), 0);
  ASSERT_EQ(solve_between(c, 4, 1.0, 1.5, found), 1);  // at the very end
}

}  // namespace
}  // namespace lentray::core
