// What a scene can ask of the integrator. What certainly never happens is left out, so that all give the
// same bits where they may be used.
#pragma once

#include "core/scene/needs.h"

namespace lentray::core {

struct PathFeatures {
  explicit PathFeatures(const Needs& needs)
      : transparency(needs.transparency || needs.refraction || needs.subsurface),
        reflection(needs.reflection),
        layers(needs.layered_textures || needs.textures_by_place || needs.interior_textures) {}
  bool transparency;  ///< filter, transmit, refraction, interiors
  bool reflection;
  bool layers;  ///< layered textures, textures by place, interior textures
};

}  // namespace lentray::core
