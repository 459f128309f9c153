// How light scatters: means over all directions, and the formulae of the manual.
#include "core/material/phase_function.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lentray::core::test {
namespace {

using Kind = PhaseFunction::Kind;

double mean(const PhaseFunction& phase) {
  constexpr int kSteps = 20000;
  double sum = 0.0;
  for (int i = 0; i < kSteps; ++i) sum += phase(-1.0 + 2.0 * (i + 0.5) / kSteps);
  return sum / kSteps;
}

TEST(UnitPhaseFunction, MeansAreWhatTheHeaderSays) {
  EXPECT_NEAR(mean({Kind::kIsotropic}), 1.0, 1e-6);
  for (const double g : {-0.7, 0.0, 0.3, 0.8}) {
    EXPECT_NEAR(mean({Kind::kHenyeyGreenstein, g}), 1.0, 1e-4) << g;
  }
  EXPECT_NEAR(mean({Kind::kRayleigh}), 1.066, 1e-3);
  EXPECT_NEAR(mean({Kind::kMieHazy}), 1.153, 1e-3);
  EXPECT_NEAR(mean({Kind::kMieMurky}), 1.247, 1e-3);
}

TEST(UnitPhaseFunction, ShapesAreTheManuals) {
  EXPECT_NEAR(PhaseFunction{Kind::kRayleigh}(1.0), 2.0 * PhaseFunction{Kind::kRayleigh}(0.0),
              1e-12);
  EXPECT_NEAR(PhaseFunction{Kind::kMieHazy}(1.0), 10.0 * PhaseFunction{Kind::kMieHazy}(-1.0),
              1e-12);
  EXPECT_NEAR(PhaseFunction{Kind::kMieMurky}(1.0), 51.0 * PhaseFunction{Kind::kMieMurky}(-1.0),
              1e-12);
  const PhaseFunction forward{Kind::kHenyeyGreenstein, 0.5}, even{Kind::kHenyeyGreenstein, 0.0};
  EXPECT_NEAR(forward(1.0), 0.75 / std::pow(0.25, 1.5), 1e-12);
  EXPECT_GT(forward(1.0), forward(-1.0));
  EXPECT_EQ(even(0.3), 1.0);
}

}  // namespace
}  // namespace lentray::core::test
