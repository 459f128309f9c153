// Descriptions of fog and rainbows -> the kernel's.
#pragma once

#include "core/scene/atmosphere.h"
#include "parser/descriptions/scene.h"

namespace lentray::parser {

/// `noise_generator`: the scene's, for turbulence. Fogs without a distance are left out.
core::Atmosphere build_atmosphere(const SceneDesc& scene, int noise_generator);

}  // namespace lentray::parser
