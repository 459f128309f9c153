// The light along a ray that is not the camera's: what gathers light for a place asks an integrator
// (core/trace/integrator.h) for it without knowing more of it. World space; colours linear. One a thread,
// which may ask again while it is answered. Who asks outside of a sample that is traced begins the
// context's indirect light itself.
#pragma once

#include <cstdint>
#include <limits>

#include "core/base/color.h"
#include "core/base/ray.h"

namespace lentray::core {

/// A ray that gathers light for a place (core/trace/indirect_light.h).
struct GatherRay {
  Ray ray;  ///< unit
  float weight;
  int level;                      ///< levels above it
  float least_importance = 0.0f;  ///< of what it may meet: less is not shaded
  std::uint64_t key = 0;          ///< of its random numbers
  std::uint8_t scattered = 0;     ///< as RayState's
};
struct GatheredRay {
  Rgb light;
  double distance = std::numeric_limits<double>::infinity();  ///< to what it met
  float importance = 1.0f;                                    ///< of that
};

class Follow {
 public:
  virtual ~Follow() = default;
  /// The ray itself sees whatever its weight and level are; what goes on from there ends where that
  /// of camera rays does.
  virtual GatheredRay gather(const GatherRay& ray) = 0;
};

}  // namespace lentray::core
