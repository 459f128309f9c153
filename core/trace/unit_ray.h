// A ray whose direction is unit, as the tracer wants it. World space.
#pragma once

#include <cmath>

#include "core/base/ray.h"

namespace lentray::core {

/// The ray itself if its direction is unit but for rounding.
inline Ray unit_ray(const Ray& ray) {
  constexpr double kUnitSlack = 1e-14;  // of the squared length of a direction
  if (std::fabs(length_squared(ray.direction) - 1.0) > kUnitSlack) {
    return {ray.origin, normalized(ray.direction)};
  }
  return ray;
}

}  // namespace lentray::core
