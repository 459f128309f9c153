// light_source descriptions -> lights of the kernel.
#pragma once

#include "core/base/transform.h"
#include "core/light/light.h"
#include "parser/descriptions/light.h"

namespace lentray::parser {

/// The light moved to the world: its points and the axes of its area; radii stay, as in stock.
core::Light build_light(const LightDesc& light, const core::Transform& to_world);

}  // namespace lentray::parser
