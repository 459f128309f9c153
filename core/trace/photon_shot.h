// A photon as it leaves its light, and what it weighs where it comes to rest. World space; power linear.
// Plain values.
// Source: reference manual 3.7, "Photons"; weights replay stock's files of photons.
#pragma once

#include <cmath>
#include <cstdint>

#include "core/base/ray.h"
#include "core/base/tiny.h"
#include "core/light/light.h"
#include "core/trace/reflectance.h"

namespace lentray::core {

struct PhotonShot {
  Ray ray;  ///< unit
  Rgb power;
  double way;  ///< that it has come already
  const Light& light;
  std::uint32_t target;  ///< its number, from 1
  double spread;         ///< PhotonUnit::spread
};

/// Of power that has come so far from the light: as many photons as reach a piece of surface there carry
/// the light that it gets.
inline Rgb weighed(const Rgb& power, double way, const PhotonShot& shot) {
  const Light& light = shot.light;
  double fading = 1.0;
  if (light.fade_power > 0.0 && std::fabs(light.fade_distance) > kTiny) {
    fading = 2.0 / (1.0 + std::pow(way / light.fade_distance, light.fade_power));
  }
  const Rgb spread = times(power, fading * shot.spread * shot.spread);
  return light.parallel ? spread : times(spread, way * way);
}

}  // namespace lentray::core
