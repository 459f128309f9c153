// +Q: calculations that a lower quality leaves out, as far as they lie outside the textures.
// Source: reference manual 3.7, "Quality Settings"; measured on stock: below 6 nothing is seen
// through, 6 and 7 see through and reflect totally inside glass, but show no mirror images.
// Quick colours, normals and unlit colours are the texture compiler's.
#pragma once

#include <memory>

#include "core/scene/scene.h"
#include "core/trace/shadow_tester.h"

namespace lentray::tool {

/// Below 5 area lights become points, below 6 nothing is seen through, below 8 nothing mirrored.
void reduce(core::SceneParts& parts, int quality);

/// Below 4 nothing casts a shadow: the tester that says so. Null from 4 on.
std::unique_ptr<core::ShadowTesterFactory> shadowless_tester(int quality);

}  // namespace lentray::tool
