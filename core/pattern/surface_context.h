// What a texture may ask beyond the point: of the surface it lies on and the ray that sees it.
// World space. Made by the renderer for each shaded point; one thread.
// Source: reference manual 3.7, "UV Mapping", "Slope", "AOI"; compared with stock by
// tests/image/surface_patterns_test.cpp.
#pragma once

#include "core/base/vec3.h"

namespace lentray::core {

struct Hit;

struct SurfaceContext {
  Vec3 point;
  /// Unit, facing the ray. Pigments see that of their layer or, as normals, of the last layer above that has one:
  /// in the space of the map that the layers are in. Without any it is the surface's, in the world.
  Vec3 normal;
  Vec3 direction;            ///< of the ray, unit
  const Hit* hit = nullptr;  ///< null: asked for a point of empty space (sky, function, media);
                             ///< patterns pass it on, and rooms above read it
};

/// For points that lie on nothing.
inline constexpr SurfaceContext kNoSurface{};

}  // namespace lentray::core
