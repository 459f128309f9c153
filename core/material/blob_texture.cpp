#include "core/material/blob_texture.h"

#include <cmath>

namespace lentray::core {

namespace {

std::vector<BlobField> fields_of(const std::vector<BlobTexture::Element>& elements) {
  std::vector<BlobField> fields;
  fields.reserve(elements.size());
  for (const BlobTexture::Element& e : elements) fields.push_back(e.field);
  return fields;
}

}  // namespace

BlobTexture::BlobTexture(std::vector<Element> elements, double least)
    : m_fields(fields_of(elements)), m_least(least) {
  m_textures.reserve(elements.size());
  for (Element& e : elements) m_textures.push_back(std::move(e.texture));
}

// The shares are those of the place in the world, also where uv_mapping has moved the point.
void BlobTexture::resolve(const Vec3& point, const SurfaceContext& surface, double weight,
                          WeightedTextures& out) const {
  const Vec3& world_point = surface.hit ? surface.point : point;
  struct Near {
    double influence;
    std::uint32_t element;
  };
  boost::container::small_vector<Near, 32> near;
  double total = 0.0;
  m_fields.at_point(world_point, [&](std::uint32_t i) {
    const BlobField& field = m_fields[i];
    const double influence = std::fabs(field.at(field.to_blob.inverse_point(world_point)));
    total += influence;
    near.push_back({influence, i});
  });
  if (total == 0.0) {
    m_textures.front()->resolve(point, surface, weight, out);
    return;
  }
  for (const Near& e : near) {
    const double share = e.influence / total;
    if (share > 0.0 && share >= m_least) {
      m_textures[e.element]->resolve(point, surface, weight * share, out);
    }
  }
}

}  // namespace lentray::core
