// Textures of one layer that look the same everywhere, as most do, with all that is the same at each of their points
// found once: surfaces that have one can be shaded many at a time (core/trace/plain_lights.h).
// Colours linear. One a thread.
#pragma once

#include <memory>
#include <optional>
#include <unordered_map>

#include "core/material/texture.h"
#include "core/object/leaf.h"
#include "core/scene/scene.h"
#include "core/trace/path_features.h"
#include "core/trace/reflectance.h"

namespace lentray::core {

/// One layer of one colour, with a finish of diffuse light and plain highlights; no normal of its own.
struct PlainTexture {
  const Finish* finish;
  Rgb pigment;
  Rgb own;              ///< light that needs no lights
  double diffuse;       ///< of the finish, the layer's share
  Rgb filter;           ///< of what is seen behind
  double transparency;  ///< 0..1: the filter's grey
  bool shines;          ///< highlights
  bool reflects;
  /// Of its mirror, where that is the same from all sides.
  std::optional<Reflectivity> mirror;
  /// Whether rays go on from it, as far as it is up to the texture.
  bool goes_on() const { return reflects || transparency > 0.0; }
};

class PlainTextures {
 public:
  explicit PlainTextures(const Scene& scene);
  /// Of a surface seen from that side; null: it has no such texture.
  const PlainTexture* find(const Leaf& leaf, bool from_behind) {
    const Attributes& attributes = leaf.attributes();
    if (attributes.double_illuminate || attributes.lights) return nullptr;
    if (m_paths.layers && has_others(leaf, from_behind)) return nullptr;
    return attributes.texture == m_last ? m_last_plain : another(attributes.texture);
  }

 private:
  /// Whether the surface may have textures besides its own.
  static bool has_others(const Leaf& leaf, bool from_behind);
  const PlainTexture* another(const Texture* texture);
  std::unique_ptr<const PlainTexture> made(const Texture& texture) const;

  const SceneSettings& m_settings;
  const PathFeatures m_paths;
  std::unordered_map<const Texture*, std::unique_ptr<const PlainTexture>> m_known;
  // What was asked for last.
  const Texture* m_last = nullptr;
  const PlainTexture* m_last_plain = nullptr;
};

}  // namespace lentray::core
