// What fills the space between surfaces: fogs, rainbows and media. World space, distances in scene units,
// angles in radians. Immutable.
// Source: reference manual 3.7, "Fog", "Rainbow"; compared with stock by tests/image/atmosphere_test.cpp.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/base/color.h"
#include "core/base/vec3.h"
#include "core/material/blend_map.h"
#include "core/material/medium.h"
#include "core/noise/noise.h"

namespace lentray::core {

struct Fog {
  double distance = 0.0;   ///< where 1/e of what is behind is left
  Colour colour;           ///< transmit: the least that is left
  bool on_ground = false;  ///< fog_type 2: thins above `offset` along `up`
  double offset = 0.0, altitude = 0.0;
  Vec3 up{0, 1, 0};  ///< unit
  std::optional<Turbulence> turbulence;
  double turbulence_depth = 0.5;
  int noise_generator = 2;
};

struct Rainbow {
  Vec3 antisolar, right, up;        ///< unit, perpendicular
  double angle = 0.0, width = 0.0;  ///< of the inner edge against `antisolar`; of the band
  double arc_angle = 0.0, falloff_angle = 0.0;  ///< half of the arc that shows, and without fading
  double distance = 1e7;
  double jitter = 0.0;
  BlendMap<Colour> colours;
};

struct Atmosphere {
  std::vector<Fog> fogs;
  std::vector<Rainbow> rainbows;
  std::vector<std::shared_ptr<const Medium>> media;
  bool is_empty() const { return fogs.empty() && rainbows.empty() && media.empty(); }
};

}  // namespace lentray::core
