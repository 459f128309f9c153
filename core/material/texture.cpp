#include "core/material/texture.h"

#include <algorithm>

#include "core/material/textures.h"

namespace lentray::core {
namespace {

class TextureMap final : public CompositeTexture {
 public:
  TextureMap(PlacedPattern pattern, BlendMap<TexturePtr> map)
      : CompositeTexture(map.items()), m_pattern(std::move(pattern)), m_map(std::move(map)) {}
  void resolve(const Vec3& point, const SurfaceContext& surface, double weight,
               WeightedTextures& out) const override {
    const auto place =
        m_map.find(m_pattern.value(m_pattern.placement.inwards(point, surface), surface));
    if (place.before == place.after) {
      (*place.after)->resolve(point, surface, weight, out);
      return;
    }
    (*place.before)->resolve(point, surface, weight * (1.0 - place.fraction), out);
    (*place.after)->resolve(point, surface, weight * place.fraction, out);
  }

 private:
  PlacedPattern m_pattern;
  BlendMap<TexturePtr> m_map;
};

class AverageTexture final : public CompositeTexture {
 public:
  explicit AverageTexture(const std::vector<std::pair<double, TexturePtr>>& entries) {
    for (const auto& [weight, texture] : entries) {
      m_weights.push_back(weight);
      m_textures.push_back(texture);
      m_total += weight;
    }
  }
  void resolve(const Vec3& point, const SurfaceContext& surface, double weight,
               WeightedTextures& out) const override {
    for (std::size_t i = 0; i < m_textures.size(); ++i) {
      m_textures[i]->resolve(point, surface, weight * m_weights[i] / m_total, out);
    }
  }

 private:
  std::vector<double> m_weights;
  double m_total = 0.0;
};

}  // namespace

bool LayeredTexture::is_opaque() const {
  return std::any_of(m_layers.begin(), m_layers.end(),
                     [](const TextureLayer& layer) { return layer.pigment->is_opaque(); });
}

bool CompositeTexture::is_opaque() const {
  return std::ranges::all_of(m_textures, [](const auto& texture) { return texture->is_opaque(); });
}

void CompositeTexture::collect(std::vector<const LayeredTexture*>& out) const {
  for (const auto& texture : m_textures) texture->collect(out);
}

TexturePtr make_texture_map(PlacedPattern pattern, BlendMap<TexturePtr> map) {
  return std::make_shared<TextureMap>(std::move(pattern), std::move(map));
}
TexturePtr make_average_texture(const std::vector<std::pair<double, TexturePtr>>& entries) {
  return std::make_shared<AverageTexture>(entries);
}

}  // namespace lentray::core
