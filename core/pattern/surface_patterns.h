// Patterns that follow the surface they lie on. The point is the pattern's, the surface the
// world's. In empty space they are 0. Immutable, any number of threads.
// Source: reference manual 3.7, "Slope", "AOI"; compared with stock by tests/image/surface_patterns_test.cpp.
#pragma once

#include "core/pattern/pattern.h"

namespace lentray::core {

struct Slope {
  Vec3 direction;  ///< any length; a world point if `point_at`
  bool point_at = false;
  Vec3 altitude;                                                          ///< null: none
  double low = 0.0, high = 0.0, altitude_low = 0.0, altitude_high = 0.0;  ///< 0, 0: the whole range
};
PatternPtr make_slope(const Slope& slope);
/// The angle between ray and normal, 1/2 where they are at right angles, 1 head on.
PatternPtr make_aoi();

}  // namespace lentray::core
