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
  /// `state`: the ray, whose direction is unit, with its kind and the interiors around its start.
  /// `weight`: its share of the pixel; black below adc_bailout. `level`: levels of the ray tree above
  /// it; black from max_trace_level on.
  virtual Radiance along(const RayState& state, float weight, int level) = 0;
};

}  // namespace lentray::core
