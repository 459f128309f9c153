// The solver that lentray uses beside the others, on a few polynomials of each order and kind; the
// whole comparison is in docs/stability/tables.md.
#include <gtest/gtest.h>

#include "tests/stability/polynomials/measure.h"
#include "tests/stability/polynomials/samples.h"

namespace lentray::stability {
namespace {

constexpr int kCount = 12;

std::vector<Case> cases_of(const std::string& kind, int order, int count) {
  std::vector<Case> cases;
  for (const Polynomial& p : samples(kind, order, count)) cases.push_back({p, Truth(p)});
  return cases;
}

const Solver& named(std::string_view name) {
  for (const Solver& s : solvers()) {
    if (s.name == name) return s;
  }
  throw std::logic_error("no such solver");
}

TEST(StabilityTruth, KnowsConstructedRoots) {
  // (x - 3)^2 (x + 2) (x^2 + 1), whole numbers: nothing is rounded.
  const Truth truth(expanded({2.0, {3.0, 3.0, -2.0}, {{0.0, 1.0}}}));
  ASSERT_EQ(truth.roots().size(), 3u);
  EXPECT_DOUBLE_EQ(truth.roots()[0].x, -2.0);
  EXPECT_DOUBLE_EQ(truth.roots()[1].x, 3.0);
  EXPECT_DOUBLE_EQ(truth.roots()[2].x, 3.0);
  EXPECT_FALSE(truth.roots()[0].is_hidden);
  EXPECT_TRUE(truth.roots()[1].is_hidden);
  EXPECT_TRUE(truth.is_zero_within_rounding(3.0));
  EXPECT_FALSE(truth.is_zero_within_rounding(2.9));
}

TEST(StabilityTruth, SeesMistakes) {
  const std::vector<Case> one = {
      {expanded({1.0, {1.0, 2.0, 4.0}, {}}), Truth(expanded({1.0, {1.0, 2.0, 4.0}, {}}))}};
  const Solver wrong{"wrong", 3, [](const Polynomial&, double* roots) {
                       roots[0] = 1.0 + 1e-6;
                       roots[1] = 3.0;
                       return 2;
                     }};
  const Figures f = figures(wrong, one);
  EXPECT_EQ(f.missed, 2);
  EXPECT_EQ(f.invented, 1);
  EXPECT_NEAR(f.largest, 1e-6, 1e-12);
}

TEST(StabilityPolynomials, RootsAreFoundAsWellAsTheCoefficientsSay) {
  for (int order = 2; order <= kMaxOrder; ++order) {
    for (const std::string& kind : kinds()) {
      const std::string name = "order " + std::to_string(order) + ", " + kind;
      const Figures f = figures(named("lentray"), cases_of(kind, order, kCount));
      EXPECT_EQ(f.polynomials, kCount) << name;
      EXPECT_EQ(f.missed, 0) << name;
      EXPECT_EQ(f.invented, 0) << name;
      // In units of what rounding the coefficients once would do to the root.
      EXPECT_LE(f.excess, 2.0 * order) << name;
    }
  }
}

}  // namespace
}  // namespace lentray::stability
