// Which textures hold at a hit: the object's, its interior texture from behind, or those of a
// mesh's faces. World space. Source: reference manual 3.7, "Interior Texture", "Mesh2".
#pragma once

#include "core/geometry/object.h"
#include "core/material/texture.h"

namespace lentray::core {

/// Appends the layered textures at a hit with their weights (sum 1). `from_behind`: the ray
/// leaves the surface's solid. Shares of a face below `least` are left out, as stock does.
void textures_at(const Hit& hit, const Vec3& point, bool from_behind, double least,
                 WeightedTextures& out);

}  // namespace lentray::core
