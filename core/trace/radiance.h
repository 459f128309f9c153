// The light that comes along a ray. Linear, in the scene's working space.
#pragma once

#include "core/base/color.h"

namespace lentray::core {

struct Radiance {
  Rgb rgb;
  float transmit =
      0.0f;  ///< of the picture's background, with +UA (1 - alpha); rgb is premultiplied

  Radiance& operator+=(const Radiance& o) {
    rgb += o.rgb;
    transmit += o.transmit;
    return *this;
  }
  friend Radiance operator*(const Radiance& a, float s) { return {a.rgb * s, a.transmit * s}; }
};

}  // namespace lentray::core
