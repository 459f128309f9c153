#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "core/base/tiny.h"
#include "core/pattern/organic.h"

namespace {

using namespace lentray::core;

double power(double d, double metric) {
  return metric == 2.0 ? d * d : metric == 1.0 ? std::fabs(d) : std::pow(std::fabs(d), metric);
}

/// The metric's power of the third least distance to random points, by asking all cells around.
double third(const Vec3& p, double metric) {
  std::array<int, 3> own{};
  for (int axis = 0; axis < 3; ++axis)
    own[static_cast<std::size_t>(axis)] = static_cast<int>(std::floor(p[axis] - kTiny));
  std::vector<double> all;
  for (int x = -2; x <= 2; ++x) {
    for (int y = -2; y <= 2; ++y) {
      for (int z = -2; z <= 2; ++z) {
        if ((x * x == 4) + (y * y == 4) + (z * z == 4) > 1) continue;
        const int at[] = {own[0] + x, own[1] + y, own[2] + z};
        const Vec3 away = Vec3(at[0], at[1], at[2]) + cell_randoms(at[0], at[1], at[2]) - p;
        all.push_back(power(away.x, metric) + power(away.y, metric) + power(away.z, metric));
      }
    }
  }
  std::sort(all.begin(), all.end());
  return all[2];
}

TEST(UnitCrackle, LeavesOutNoPointThatIsNearEnough) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(-40.0, 40.0);
  for (const double metric : {1.0, 2.0, 3.5}) {
    // Weights of the three distances: the third's alone, small enough not to be cut off at 1.
    const PatternPtr pattern = make_crackle({.form = {0.0, 0.0, 0.25}, .metric = metric}, 2);
    for (int i = 0; i < 3000; ++i) {
      Vec3 p{place(random), place(random), place(random)};
      if (i % 3 == 0) p.x = std::round(p.x) + (i % 2 ? kTiny : 0.0);
      const double d = third(p, metric);
      const double root = metric == 2.0   ? std::sqrt(d)
                          : metric == 1.0 ? d
                                          : std::pow(d, 1.0 / metric);
      ASSERT_EQ(pattern->value(p), std::clamp(0.25 * root, 0.0, 1.0)) << metric << ", point " << i;
    }
  }
}

}  // namespace
