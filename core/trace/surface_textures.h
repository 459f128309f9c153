// Which textures hold at a hit: the object's, its interior texture from behind, or those of a
// mesh's faces. World space. Source: reference manual 3.7, "Interior Texture", "Mesh2".
#pragma once

#include "core/material/texture.h"
#include "core/object/leaf.h"

namespace lentray::core {

/// Appends the layered textures at a hit with their weights (sum 1). `from_behind`: the ray
/// leaves the surface's solid. Shares of a face below `least` are left out.
void textures_at(const SurfaceContext& surface, bool from_behind, double least,
                 WeightedTextures& out);
/// Where the textures of a surface are asked: its point, or (u, v, 0) under uv_mapping.
inline Vec3 texture_point(const SurfaceContext& surface) {
  const Leaf& leaf = *surface.hit->leaf;
  if (!leaf.attributes().uv_mapping) return surface.point;
  const Vec2 uv = leaf.uv(surface.point, surface.hit->shape);
  return {uv.u, uv.v, 0.0};
}

}  // namespace lentray::core
