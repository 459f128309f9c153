// The ladder of ever more exact settings that a reference converges along. Pure functions.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/lentray-chart/matrix.h"

namespace lentray::chart {

struct ReferenceStep {
  std::string what;                  ///< for readers
  std::vector<std::string> options;  ///< on top of the user's own
  double work = 1.0;                 ///< about how many times the work of the step before
};

/// Step 0, 1, ... of what the scene uses: twice the samples of pixels and area lights from step to step; of focal blur and
/// media, whose samples also grow with those of the pixel, the root of it; of radiosity
/// twice the rays and the samples, and one more bounce. Nothing where no step is left. `of_lens_models`: with the truest lens model there is, instead of the user's own.
std::optional<ReferenceStep> reference_step(const MatrixRequest& request, int step,
                                            bool of_lens_models);

/// Errors below this need not be distinguished: a third of what rounding to 8 bits makes. 1/255
inline constexpr double kSmallestError = 0.1;

/// Whether a reference that changed by `change` is good for errors down to `smallest` (both rms, 1/255).
bool is_converged(double change, double smallest);

}  // namespace lentray::chart
