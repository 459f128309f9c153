// Lens sheets by name: what is sold commonly, and the form in which users add their own.
// Pure; any number of threads.
#pragma once

#include <string>
#include <vector>

#include "camera/lens_data.h"

namespace lentray::camera {

struct LensProfile {
  std::string name;
  LensData data;
  bool nominal = false;  ///< the thickness is computed from the pitch: no maker says it
  std::string source;    ///< where the data are from, for lists
};

/// Sheets of 10 to 200 lenses an inch, coarse ones first. Where no public source gives more than the
/// pitch the profile is nominal: polystyrene of index 1.59, as thin as it can be to focus on its back,
/// n P/(2 (n - 1)) rounded up to 0.01 mm. Thinner than most that are sold for pictures with depth.
std::vector<LensProfile> common_lens_sheets();

}  // namespace lentray::camera
