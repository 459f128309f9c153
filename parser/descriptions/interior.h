// What fills an object, and `material`, a texture with an interior.
// Source: reference manual 3.7, "Interior", "Material".
#pragma once

#include <vector>

#include "core/base/color.h"
#include "parser/descriptions/media.h"
#include "parser/descriptions/texture.h"

namespace lentray::parser {

struct InteriorDesc {
  Location where;
  double ior = 1.0;
  bool ior_given = false;  ///< an old scene's texture may give it instead
  double dispersion = 1.0;
  int dispersion_samples = 7;
  double caustics = 0.0;
  double fade_distance = 0.0, fade_power = 0.0;
  core::Rgb fade_colour;
  std::vector<Ref<MediaDesc>> media;
};

struct MaterialDesc {
  Location where;
  Ref<TextureDesc> texture, interior_texture;  ///< null: not given
  Ref<InteriorDesc> interior;
};

Ref<InteriorDesc> transformed(Ref<InteriorDesc> interior, const core::Transform& transform);

}  // namespace lentray::parser
