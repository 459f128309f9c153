#include "core/trace/surface_textures.h"

#include <typeinfo>

#include "core/object/leaf.h"
#include "core/shape/mesh.h"

namespace lentray::core {

void textures_at(const SurfaceContext& surface, bool from_behind, double least,
                 WeightedTextures& out) {
  const Hit& hit = *surface.hit;
  const Vec3 point = texture_point(surface);
  const Attributes& attributes = hit.leaf->attributes();
  const bool interior = from_behind && attributes.interior_texture;
  const Texture* own = interior ? attributes.interior_texture : attributes.texture;
  const Shape& shape = hit.leaf->shape();
  const Mesh* mesh = typeid(shape) == typeid(Mesh) ? static_cast<const Mesh*>(&shape) : nullptr;
  if (!mesh || !mesh->has_textures() || interior) {
    own->resolve(point, surface, 1.0, out);
    return;
  }
  MeshTexture shares[3];
  const int count = mesh->textures_at(hit.shape, shares);
  for (int i = 0; i < count; ++i) {
    const Texture* texture = shares[i].texture ? shares[i].texture : own;
    if (shares[i].weight >= least) texture->resolve(point, surface, shares[i].weight, out);
  }
}

}  // namespace lentray::core
