#include "core/material/texture.h"

#include <algorithm>
#include <utility>

#include "core/material/normals.h"
#include "core/material/pigments.h"
#include "core/material/textures.h"

namespace lentray::core {
namespace {

class TextureMap final : public CompositeTexture {
 public:
  TextureMap(PlacedPattern pattern, const BlendMap<TexturePtr>& map)
      : m_pattern(std::move(pattern)), m_map(map) {}
  void resolve(const Vec3& point, const SurfaceContext& surface, double weight,
               WeightedTextures& out) const override {
    const Vec3 local = m_pattern.placement.inwards(point, surface);
    const auto place = m_map.find(m_pattern.value(local, surface));
    const std::uint32_t around = out.enter(m_pattern.placement);
    if (place.before == place.after) {
      (*place.after)->resolve(local, surface, weight, out);
    } else {
      (*place.before)->resolve(local, surface, weight * (1.0 - place.fraction), out);
      (*place.after)->resolve(local, surface, weight * place.fraction, out);
    }
    out.leave(around);
  }

 private:
  std::span<const TexturePtr> parts() const override { return m_map.items(); }

  PlacedPattern m_pattern;
  BlendMap<TexturePtr> m_map;
};

class AverageTexture final : public CompositeTexture {
 public:
  AverageTexture(Placement placement, const BlendMap<TexturePtr>& map)
      : m_placement(std::move(placement)), m_map(map) {
    for (const double weight : map.values()) m_total += weight;
  }
  void resolve(const Vec3& point, const SurfaceContext& surface, double weight,
               WeightedTextures& out) const override {
    const Vec3 local = m_placement.inwards(point, surface);
    const std::uint32_t around = out.enter(m_placement);
    for (std::size_t i = 0; i < m_map.items().size(); ++i) {
      m_map.items()[i]->resolve(local, surface, weight * m_map.values()[i] / m_total, out);
    }
    out.leave(around);
  }

 private:
  std::span<const TexturePtr> parts() const override { return m_map.items(); }

  Placement m_placement;
  BlendMap<TexturePtr> m_map;
  double m_total = 0.0;
};

class PlacedTexture final : public CompositeTexture {
 public:
  PlacedTexture(Placement placement, TexturePtr texture)
      : m_placement(std::move(placement)), m_texture(std::move(texture)) {}
  void resolve(const Vec3& point, const SurfaceContext& surface, double weight,
               WeightedTextures& out) const override {
    const std::uint32_t around = out.enter(m_placement);
    m_texture->resolve(m_placement.inwards(point, surface), surface, weight, out);
    out.leave(around);
  }

 private:
  std::span<const TexturePtr> parts() const override { return {&m_texture, 1}; }

  Placement m_placement;
  TexturePtr m_texture;
};

}  // namespace

bool LayeredTexture::is_opaque() const {
  return std::any_of(m_layers.begin(), m_layers.end(),
                     [](const TextureLayer& layer) { return layer.pigment->is_opaque(); });
}

bool CompositeTexture::is_opaque() const {
  return std::ranges::all_of(parts(), [](const auto& texture) { return texture->is_opaque(); });
}

void CompositeTexture::collect(std::vector<const LayeredTexture*>& out) const {
  for (const auto& texture : parts()) texture->collect(out);
}

namespace {

Vec3 entered(const TextureSpace* spaces, std::uint32_t space, const Vec3& normal) {
  if (space == 0) return normal;
  const TextureSpace& here = spaces[space - 1];
  const Vec3 outer = entered(spaces, here.around, normal);
  return normalized(here.placement->normal_inwards(normalized(outer)));
}

}  // namespace

Vec3 TexturePlace::inside(const Vec3& normal) const { return entered(spaces, space, normal); }

Vec3 TexturePlace::outside(Vec3 normal) const {
  for (std::uint32_t at = space; at != 0; at = spaces[at - 1].around) {
    normal = normalized(spaces[at - 1].placement->normal_outwards(normalized(normal)));
  }
  return normal;
}

TexturePtr make_texture_map(PlacedPattern pattern, const BlendMap<TexturePtr>& map) {
  return std::make_shared<TextureMap>(std::move(pattern), map);
}
TexturePtr make_average_texture(Placement placement, const BlendMap<TexturePtr>& map) {
  return std::make_shared<AverageTexture>(std::move(placement), map);
}
TexturePtr make_placed_texture(Placement placement, const TexturePtr& texture) {
  const LayeredTexture* everywhere = texture->everywhere();
  if (!everywhere) return std::make_shared<PlacedTexture>(std::move(placement), texture);
  std::vector<TextureLayer> layers = everywhere->layers();
  for (TextureLayer& layer : layers) {
    if (!layer.pigment->constant()) layer.pigment = make_placed_pigment(placement, layer.pigment);
    if (layer.normal) layer.normal = make_placed_normal(placement, layer.normal, false);
  }
  return std::make_shared<LayeredTexture>(std::move(layers));
}

}  // namespace lentray::core
