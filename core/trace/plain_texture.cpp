#include "core/trace/plain_texture.h"

#include <algorithm>
#include <cmath>
#include <typeinfo>

#include "core/shape/mesh.h"
#include "core/trace/layer_opacity.h"

namespace lentray::core {
namespace {

bool is_plain(const Finish& finish) {
  const bool is_diffuse_alone = finish.diffuse > 0.0 && finish.diffuse_back == 0.0 &&
                                finish.brilliance == 1.0 && !(finish.crand > 0.0) &&
                                !finish.subsurface;
  return is_diffuse_alone && !(finish.metallic > 0.0) && !(finish.irid > 0.0) &&
         !finish.conserve_energy;
}

/// Whether reflectivity() is the same for all angles.
bool reflects_evenly(const Finish& finish) {
  return !finish.reflection_fresnel && finish.reflection_min == finish.reflection_max &&
         finish.reflection_metallic == 0.0;
}

}  // namespace

PlainTextures::PlainTextures(const Scene& scene)
    : m_settings(scene.settings()), m_paths(scene.needs()) {}

bool PlainTextures::has_others(const Leaf& leaf, bool from_behind) {
  if (from_behind && leaf.attributes().interior_texture) return true;
  const Shape& shape = leaf.shape();
  return typeid(shape) == typeid(Mesh) && static_cast<const Mesh&>(shape).has_textures();
}

const PlainTexture* PlainTextures::another(const Texture* texture) {
  const auto [at, is_new] = m_known.try_emplace(texture);
  if (is_new) at->second = made(*texture);
  m_last = texture;
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
  if (plain->reflects && reflects_evenly(finish)) {
    constexpr double kAnyCosine = 0.5, kAnyIor = 1.0;
    plain->mirror = reflectivity(finish, kAnyCosine, kAnyIor, colour->rgb);
  }
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
