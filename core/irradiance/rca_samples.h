// Samples as a radiosity file (.rca) has them: a line a sample, without its quality, and with 8 bits
// for each part of a normal. Samples that are read back are therefore not quite those that were written.
// World space, colours linear. Pure functions.
// Source: lines of files that `povray +RFO` wrote, beside the samples they are of
// (tests/image/radiosity_files_test.cpp).
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/irradiance/sample.h"

namespace lentray::core {

class IrradianceCache;

/// A sample of the store of that depth.
struct DepthSample {
  int depth = 0;
  IrradianceSample sample;
};

struct RcaSamples {
  std::vector<DepthSample> samples;   ///< in the file's order
  std::size_t passed_over = 0;        ///< lines that are no samples
  std::size_t first_passed_over = 0;  ///< the number of the first one, from 1; 0: there is none
};

/// Lines that are no samples are passed over. The last line always is: files end with an empty one.
RcaSamples read_rca_samples(std::string_view text);

/// The lines of all samples of a cache, depth by depth, but for the first `known[depth]` of each.
std::string rca_samples_text(const IrradianceCache& cache, const std::vector<std::size_t>& known);

}  // namespace lentray::core
