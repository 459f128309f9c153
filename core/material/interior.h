// What fills an object. Source: reference manual 3.7, "Interior".
#pragma once

#include <memory>
#include <vector>

#include "core/base/color.h"
#include "core/material/medium.h"

namespace lentray::core {

inline constexpr int kDefaultBands = 7;

struct Interior {
  double ior = 1.0;
  double dispersion = 1.0;                 ///< ior of violet over ior of red
  int dispersion_samples = kDefaultBands;  ///< bands that light is split into
  double caustics = 0.0;
  float passed = 1.0f;  ///< the part of the light that a surface lets through; may exceed 1
  double fade_distance = 0.0, fade_power = 0.0;
  Rgb fade_colour;
  std::vector<std::shared_ptr<const Medium>> media;
};

}  // namespace lentray::core
