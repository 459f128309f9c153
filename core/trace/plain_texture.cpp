#include "core/trace/plain_texture.h"

#include <algorithm>
#include <cmath>
#include <typeinfo>

#include "core/shape/mesh.h"
#include "core/trace/layer_opacity.h"
#include "core/trace/reflectance.h"

namespace lentray::core {
namespace {

bool is_plain(const Finish& finish) {
  const bool is_diffuse_alone = finish.diffuse > 0.0 && finish.diffuse_back == 0.0 &&
                                finish.brilliance == 1.0 && !(finish.crand > 0.0) &&
                                !finish.subsurface;
  return is_diffuse_alone && !(finish.metallic > 0.0) && !(finish.irid > 0.0) &&
         !finish.conserve_energy;
}

/// Whether faces of it may have textures of their own.
bool may_have_many(const Leaf& leaf) {
  const Shape& shape = leaf.shape();
  return typeid(shape) == typeid(Mesh) && static_cast<const Mesh&>(shape).has_textures();
}

}  // namespace

PlainTextures::PlainTextures(const Scene& scene)
    : m_settings(scene.settings()), m_paths(scene.needs()) {}

const PlainTexture* PlainTextures::find(const Leaf& leaf, bool from_behind) {
  const Attributes& attributes = leaf.attributes();
  if (attributes.double_illuminate || attributes.lights) return nullptr;
  if (m_paths.layers && ((from_behind && attributes.interior_texture) || may_have_many(leaf)))
    return nullptr;
  if (attributes.texture == m_last) return m_last_plain;
  const auto [at, is_new] = m_known.try_emplace(attributes.texture);
  if (is_new) at->second = made(*attributes.texture);
  m_last = attributes.texture;
  m_last_plain = at->second.get();
  return m_last_plain;
}

/// The operations and their order are those of SurfaceShading::shade_layer().
std::unique_ptr<const PlainTexture> PlainTextures::made(const Texture& texture) const {
  const LayeredTexture* layered = texture.everywhere();
  if (!layered || layered->layers().size() != 1) return nullptr;
  const TextureLayer& layer = layered->layers().front();
  const Finish& finish = *layer.finish;
  const Colour* colour = layer.pigment->constant();
  if (!colour || layer.normal || !is_plain(finish)) return nullptr;
  auto plain = std::make_unique<PlainTexture>();
  plain->finish = &finish;
  plain->pigment = colour->rgb;
  const bool may_be_clear = m_paths.transparency || m_paths.layers;
  const double opacity = may_be_clear ? layer_opacity(*colour, m_settings) : 1.0;
  plain->own = times(colour->rgb * finish.ambient * m_settings.ambient_light, opacity);
  plain->own += times(colour->rgb * finish.emission, opacity);
  plain->diffuse = finish.diffuse * opacity;
  plain->shines = has_highlights(finish);
  plain->reflects = m_paths.reflection && reflects(finish);
  if (may_be_clear) {
    plain->filter = Rgb(1.0f);
    plain->filter *= passed(*colour);
    plain->transparency = std::min(1.0, static_cast<double>(std::fabs(grey(plain->filter))));
  } else {
    plain->filter = Rgb(1.0f);
    plain->transparency = 0.0;
  }
  return plain;
}

}  // namespace lentray::core
