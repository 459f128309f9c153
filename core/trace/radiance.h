// The light that comes along a ray. Linear, in the scene's working space.
#pragma once

#include "core/base/color.h"

namespace lentray::core {

struct Radiance {
  Rgb rgb;
  float transmit =
      0.0f;  ///< of the picture's background, with +UA (1 - alpha); rgb is premultiplied
};

}  // namespace lentray::core
