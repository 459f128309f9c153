// The camera that the tests of converted cameras start from.
#pragma once

#include "camera/projection.h"

namespace lentray::camera {

/// Looks along z from z = -10; its sheet is at z = 0 there, 8.9 x 6.7 units.
inline Projection plain_camera() {
  Projection p;
  p.location = {1.0, 2.0, -10.0};
  p.direction = {0.0, 0.0, 1.5};
  p.right = {4.0 / 3.0, 0.0, 0.0};
  p.up = {0.0, 1.0, 0.0};
  p.look_at_distance = 10.0;
  return p;
}

}  // namespace lentray::camera
