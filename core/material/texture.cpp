#include "core/material/texture.h"

#include <algorithm>

#include "core/material/textures.h"

namespace lentray::core {
namespace {

class TextureMap final : public Texture {
 public:
  TextureMap(PlacedPattern pattern, BlendMap<TexturePtr> map)
      : m_pattern(std::move(pattern)), m_map(std::move(map)) {}
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
  bool is_opaque() const override {
    return std::all_of(m_map.items().begin(), m_map.items().end(),
                       [](const TexturePtr& texture) { return texture->is_opaque(); });
  }
  void collect(std::vector<const LayeredTexture*>& out) const override {
    for (const TexturePtr& texture : m_map.items()) texture->collect(out);
  }

 private:
  PlacedPattern m_pattern;
  BlendMap<TexturePtr> m_map;
};

class AverageTexture final : public Texture {
 public:
  explicit AverageTexture(std::vector<std::pair<double, TexturePtr>> entries)
      : m_entries(std::move(entries)) {
    for (const auto& [weight, texture] : m_entries) m_total += weight;
  }
  void resolve(const Vec3& point, const SurfaceContext& surface, double weight,
               WeightedTextures& out) const override {
    for (const auto& [share, texture] : m_entries) {
      texture->resolve(point, surface, weight * share / m_total, out);
    }
  }
  bool is_opaque() const override {
    return std::all_of(m_entries.begin(), m_entries.end(),
                       [](const auto& entry) { return entry.second->is_opaque(); });
  }
  void collect(std::vector<const LayeredTexture*>& out) const override {
    for (const auto& [weight, texture] : m_entries) texture->collect(out);
  }

 private:
  std::vector<std::pair<double, TexturePtr>> m_entries;
  double m_total = 0.0;
};

}  // namespace

bool LayeredTexture::is_opaque() const {
  return std::any_of(m_layers.begin(), m_layers.end(),
                     [](const TextureLayer& layer) { return layer.pigment->is_opaque(); });
}

TexturePtr make_texture_map(PlacedPattern pattern, BlendMap<TexturePtr> map) {
  return std::make_shared<TextureMap>(std::move(pattern), std::move(map));
}
TexturePtr make_average_texture(std::vector<std::pair<double, TexturePtr>> entries) {
  return std::make_shared<AverageTexture>(std::move(entries));
}

}  // namespace lentray::core
