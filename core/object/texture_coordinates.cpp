#include "core/object/leaf.h"
#include "core/object/object.h"
#include "core/pattern/surface_context.h"

namespace lentray::core {

Vec2 texture_coordinates(const SurfaceContext& surface) {
  if (!surface.hit) return {};
  return surface.hit->leaf->uv(surface.point, surface.hit->shape);
}

}  // namespace lentray::core
