// What a scene can ask of the integrator. Each combination is compiled on its own: a path leaves out
// what certainly never happens, so every path gives the same bits where it may be used. A feature that
// costs one branch a ray or less is no feature here but a member that is null or false
// (fog, start interiors, light groups).
#pragma once

#include "core/scene/needs.h"

namespace lentray::core {

/// Bits of the integrator's template argument.
enum PathFeature : unsigned {
  kPathTransparency = 1,  ///< filter, transmit, refraction, interiors
  kPathReflection = 2,
  kPathLayers = 4,  ///< layered textures, textures by place, interior textures
  kPathArea = 8,    ///< area lights
};
inline constexpr unsigned kAllPaths = 16;

/// Those that a scene needs.
unsigned path_features(const Needs& needs);

}  // namespace lentray::core
