// A piece of a ray.
#pragma once

#include "core/base/ray.h"

namespace lentray::core {

/// From the ray's origin on.
struct Segment {
  Ray ray;  ///< unit direction
  double length;
};

}  // namespace lentray::core
