#include "core/material/cutaway_texture.h"

#include <boost/container/small_vector.hpp>

namespace lentray::core {
namespace {

using Part = CutawayTexture::Part;

/// visit(texture) for the parts below `part` that hold at the point.
template <class Visit>
void for_holding(const Part& part, const Vec3& at, const Visit& visit) {
  for (const Part& child : part.parts) {
    if (child.object->inside(at)) {
      if (!child.parts.empty()) {
        for_holding(child, at, visit);
      } else if (child.texture) {
        visit(*child.texture);
      }
    }
    if (part.only_first) return;
  }
}

template <class Visit>
void for_each_texture(const Part& part, const Visit& visit) {
  if (part.texture) visit(*part.texture);
  for (const Part& child : part.parts) for_each_texture(child, visit);
}

}  // namespace

CutawayTexture::CutawayTexture(Part whole, double least)
    : m_whole(std::move(whole)), m_least(least) {
  for_each_texture(m_whole, [this](const Texture& t) { m_opaque = m_opaque && t.is_opaque(); });
}

// Asked are the objects at the place in the world, also where uv_mapping has moved the point.
void CutawayTexture::resolve(const Vec3& point, const SurfaceContext& surface, double weight,
                             WeightedTextures& out) const {
  const Vec3& at = surface.hit ? surface.point : point;
  boost::container::small_vector<const Texture*, 8> holding;
  for_holding(m_whole, at, [&](const Texture& texture) { holding.push_back(&texture); });
  const auto count = static_cast<double>(holding.size());
  if (holding.empty() || 1.0 / count < m_least) return;
  for (const Texture* texture : holding) texture->resolve(point, surface, weight / count, out);
}

void CutawayTexture::collect(std::vector<const LayeredTexture*>& out) const {
  for_each_texture(m_whole, [&](const Texture& texture) { texture.collect(out); });
}

}  // namespace lentray::core
