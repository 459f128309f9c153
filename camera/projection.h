// The frame of an ordinary camera after look_at, angle, sky and transforms: what stock's own
// camera has left when the scene is read. World space, vectors exactly as given: neither unit nor
// perpendicular unless the scene made them so.
#pragma once

#include <optional>

#include "core/base/vec3.h"

namespace lentray::camera {

struct Projection {
  core::Vec3 location{0.0, 0.0, 0.0};
  core::Vec3 direction{0.0, 0.0, 1.0};
  core::Vec3 right{1.33, 0.0, 0.0};
  core::Vec3 up{0.0, 1.0, 0.0};
  std::optional<double> look_at_distance;  ///< from location to look_at, after transforms
};

}  // namespace lentray::camera
