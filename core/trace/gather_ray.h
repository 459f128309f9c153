// A ray that gathers light for a place (core/trace/indirect_light.h), and what it brings. World space;
// colours linear.
#pragma once

#include <cstdint>
#include <limits>

#include "core/base/color.h"
#include "core/base/ray.h"

namespace lentray::core {

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

}  // namespace lentray::core
