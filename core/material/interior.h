// What fills an object. Source: reference manual 3.7, "Interior".
#pragma once

#include "core/base/color.h"

namespace lentray::core {

struct Interior {
  double ior = 1.0;
  double dispersion = 1.0;  ///< kept; rendered later
  int dispersion_samples = 7;
  double caustics = 0.0;
  double fade_distance = 0.0, fade_power = 0.0;
  Rgb fade_colour;
  bool has_media = false;  ///< kept; rendered later
};

}  // namespace lentray::core
