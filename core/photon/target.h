// An object that photons are shot at. World space. Plain values.
// Source: reference manual 3.7, "Photons".
#pragma once

#include <optional>

#include "core/base/vec3.h"

namespace lentray::core {

/// What an object or a light says, or both together: neither may forbid what one of them wants.
constexpr bool photons_go_on(std::optional<bool> object, std::optional<bool> light) {
  return object.value_or(light.value_or(false)) && light.value_or(true);
}

struct PhotonTarget {
  Vec3 centre;                                 ///< of the ball about the box of the object
  double radius = 0.0;                         ///< of that ball
  double factor = 1.0;                         ///< of the spacing of photons
  std::optional<bool> reflection, refraction;  ///< empty: not said
  bool collects = true;
};

}  // namespace lentray::core
