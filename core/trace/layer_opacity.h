// How much of its light a layer of a texture keeps. Pure.
#pragma once

#include "core/base/color.h"
#include "core/scene/scene.h"
#include "core/trace/reflectance.h"

namespace lentray::core {

/// The share of light that a layer of that colour does not let through.
inline float layer_opacity(const Colour& c, const SceneSettings& settings) {
  constexpr int kByAlphaSince = 370;
  // Scenes before 3.7 weigh the filter by the brightest channel.
  if (settings.language_version < kByAlphaSince) {
    return 1.0f - (c.filter * greatest(c.rgb) + c.transmit);
  }
  return 1.0f - c.filter - c.transmit;
}

}  // namespace lentray::core
