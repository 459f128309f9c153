// The layers of textures at places of surfaces, evaluated before any light is asked for: colour,
// normal, mirror, and what passes them. What is the same at each point of a texture is found once.
// World space; colours linear. One a thread.
// Source: reference manual 3.7, "Finish", "Layered Textures"; the order of the steps and where adc_bailout ends them
// measured on stock (tests/image/shading_depth_test.cpp).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_map>

#include "core/material/texture.h"
#include "core/object/leaf.h"
#include "core/scene/scene.h"
#include "core/trace/interior_table.h"
#include "core/trace/layer.h"
#include "core/trace/path_features.h"
#include "core/trace/path_rules.h"
#include "core/trace/ray_state.h"

namespace lentray::core {

struct ThreadContext;

class SurfaceLayers {
 public:
  SurfaceLayers(const ThreadContext& context, const PathRules& rules);
  /// False: lights make nothing of the surface, whatever arrives of them.
  bool may_be_lit(const Leaf& leaf, bool from_behind) {
    return may_have_others(leaf) || kind_of(texture_of(leaf, from_behind)).may_be_lit;
  }
  /// Appends the layers of the place that a ray has met, from the top of each texture down to where next to nothing
  /// passes.
  PlaceLayers find(const RayState& state, const Hit& hit, const MetPlace& where, LayerBuffer& out);

  /// Who looks at a texture.
  struct Eye {
    const Ray& ray;
    const Hit& hit;
    const Vec3& normal;  ///< of the surface, facing the ray
    InteriorsId inside;  ///< that the ray lies in
    /// The colour of a layer has been through those above it, as photons have it. Colours that neither pass light nor
    /// tint a mirror are left out.
    bool is_photon = false;
  };
  /// The same of one texture, for `place`. `surface`: as patterns see it, which layers' normals change.
  void find_in(const LayeredTexture& texture, const TexturePlace& place, const Eye& eye,
               SurfaceContext& surface, std::vector<Layer>& out) const;

 private:
  /// Of a texture, at all points.
  struct Kind {
    bool may_be_lit = false, is_plain = true;
    const LayeredTexture* everywhere = nullptr;  ///< null: a texture by place
    std::optional<Layer> fixed;                  ///< the only layer, if it is the same everywhere
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
    const Asked& last = m_asked[place_of(texture)];
    return texture == last.texture ? *last.kind : another(texture);
  }
  const Kind& another(const Texture* texture);
  Kind made(const Texture& texture) const;
  void find_blended(const Eye& eye, const MetPlace& where, SurfaceContext& surface,
                    PlaceLayers& found, LayerBuffer& out);
  /// All but the normal, the mirror and what passes.
  void fill(const TextureLayer& layer, const Colour& colour, Layer& out) const;
  Reflectivity mirror_of(const Layer& layer, const Eye& eye) const;
  /// Of a finish that reflects.
  Reflectivity seen_mirror(const Layer& layer, const Eye& eye) const;
  /// `above`: as `below` of the layer above.
  void pass(const Colour& colour, const Rgb& above, Layer& out) const;

  const ThreadContext& m_context;
  const SceneSettings& m_settings;
  const PathRules m_rules;
  const PathFeatures m_paths;
  const bool m_may_be_clear;
  WeightedTextures m_found;
  std::unordered_map<const Texture*, Kind> m_known;
  /// What was asked for last.
  struct Asked {
    const Texture* texture = nullptr;
    const Kind* kind = nullptr;
  };
  std::array<Asked, 16> m_asked{};
  static std::size_t place_of(const Texture* texture) {
    return reinterpret_cast<std::uintptr_t>(texture) / 64 % 16;
  }
};

}  // namespace lentray::core
