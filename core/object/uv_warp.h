// The warp of uv_mapping. Immutable. Source: reference manual 3.7, "UV Mapping".
#pragma once

#include "core/pattern/placement.h"

namespace lentray::core {

/// From the surface's texture coordinates on, whatever the point; 0 where there is no surface.
WarpPtr make_uv_warp();

}  // namespace lentray::core
