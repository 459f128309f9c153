// The light along a ray: what shading and passes may ask of an integrator (core/trace/integrator.h)
// without knowing it. Who asks outside of a sample that is traced begins the context's random
// numbers. World space; colours linear. One a thread, which may ask again while it is answered.
#pragma once

#include "core/trace/radiance.h"

namespace lentray::core {

struct RayState;

class Follow {
 public:
  virtual ~Follow() = default;
  /// The ray's direction is unit; its state says the share of the pixel that it has (black below
  /// adc_bailout) and the levels of the ray tree above it (black from max_trace_level on).
  virtual Radiance along(const RayState& state) = 0;
};

}  // namespace lentray::core
