// Layers of textures at places of surfaces, evaluated before any light is asked for: surfaces whose layers all have
// finishes of a few kinds can be lit many at a time (core/trace/plain_lights.h). What is the same at each point of a
// texture is found once.
// World space; colours linear. One a thread.
#pragma once

#include <cstddef>
#include <optional>
#include <unordered_map>

#include "core/material/texture.h"
#include "core/object/leaf.h"
#include "core/scene/scene.h"
#include "core/trace/path_features.h"
#include "core/trace/ray_state.h"
#include "core/trace/reflectance.h"

namespace lentray::core {

/// A layer at a place, with a finish of diffuse light and highlights: all of it but the light that lights make.
struct PlainLayer {
  PlainLayer() {}  // not defaulted: that would clear all
  const Finish* finish;
  Rgb pigment;
  Rgb own;         ///< light that needs no lights
  double diffuse;  ///< of the finish, the layer's share
  Rgb passed;      ///< of what is seen behind
  Vec3 normal;     ///< unit, of the layer
  bool is_turned;  ///< it has a normal of its own
  bool is_lit;     ///< by lights
  bool shines;     ///< highlights
  bool reflects;
  /// Of its mirror, where that is the same from all sides.
  std::optional<Reflectivity> mirror;
};

class PlainTextures {
 public:
  static constexpr std::size_t kMostLayers = 4;

  explicit PlainTextures(const Scene& scene);
  /// False: lights make nothing of the surface, whatever arrives of them.
  bool may_be_lit(const Leaf& leaf, bool from_behind) {
    return may_have_others(leaf) || kind_of(texture_of(leaf, from_behind)).may_be_lit;
  }
  /// Writes the layers of the place that a ray has met, from the top, down to where next to nothing passes; `out`: room
  /// for kMostLayers. Returns how many; 0: it has others.
  std::size_t find_layers(const Ray& ray, const Hit& hit, const MetPlace& where, PlainLayer* out);

 private:
  /// Of a texture, at all points.
  struct Kind {
    bool may_be_lit = false, is_plain = true;
    const LayeredTexture* everywhere = nullptr;  ///< null: a texture by place
    std::optional<PlainLayer> fixed;             ///< the only layer, if it is the same everywhere
  };
  const Texture* texture_of(const Leaf& leaf, bool from_behind) const {
    const Attributes& attributes = leaf.attributes();
    const bool inner = m_paths.layers && from_behind && attributes.interior_texture;
    return inner ? attributes.interior_texture : attributes.texture;
  }
  /// Whether faces of the surface may have textures of their own.
  bool may_have_others(const Leaf& leaf) const { return m_paths.layers && has_others(leaf); }
  static bool has_others(const Leaf& leaf);
  const Kind& kind_of(const Texture* texture) {
    return texture == m_last ? *m_last_kind : another(texture);
  }
  const Kind& another(const Texture* texture);
  Kind made(const Texture& texture) const;
  void fill(const TextureLayer& layer, const Colour& colour, PlainLayer& out) const;
  const LayeredTexture* resolved(const Texture& texture, const SurfaceContext& surface,
                                 TexturePlace& place);

  const SceneSettings& m_settings;
  const PathFeatures m_paths;
  const bool m_may_be_clear;
  WeightedTextures m_found;
  std::unordered_map<const Texture*, Kind> m_known;
  // What was asked for last.
  const Texture* m_last = nullptr;
  const Kind* m_last_kind = nullptr;
};

}  // namespace lentray::core
