#include "core/material/blob_texture.h"

#include <algorithm>
#include <cmath>

namespace lentray::core {

// The shares are those of the place in the world, also where uv_mapping has moved the point.
void BlobTexture::resolve(const Vec3& point, const SurfaceContext& surface, double weight,
                          WeightedTextures& out) const {
  const Vec3& world_point = surface.hit ? surface.point : point;
  const auto influence = [&](const Element& e) {
    return std::fabs(e.field.at(e.field.to_blob.inverse_point(world_point)));
  };
  double total = 0.0;
  for (const Element& e : m_elements) total += influence(e);
  if (total == 0.0) {
    m_elements.front().texture->resolve(point, surface, weight, out);
    return;
  }
  for (const Element& e : m_elements) {
    const double share = influence(e) / total;
    if (share > 0.0 && share >= m_least) {
      e.texture->resolve(point, surface, weight * share, out);
    }
  }
}

bool BlobTexture::is_opaque() const {
  return std::all_of(m_elements.begin(), m_elements.end(),
                     [](const Element& e) { return e.texture->is_opaque(); });
}

void BlobTexture::collect(std::vector<const LayeredTexture*>& out) const {
  for (const Element& e : m_elements) e.texture->collect(out);
}

}  // namespace lentray::core
