#include "core/trace/plain_texture.h"

#include <algorithm>
#include <cmath>
#include <typeinfo>

#include "core/shape/mesh.h"
#include "core/trace/layer_opacity.h"
#include "core/trace/surface_textures.h"

namespace lentray::core {
namespace {

bool is_plain(const Finish& finish) {
  if (finish.subsurface) return false;
  if (!shows_light(finish)) return true;
  return finish.diffuse >= 0.0 && finish.diffuse_back == 0.0 && !(finish.crand > 0.0) &&
         !(finish.irid > 0.0);
}

/// Whether reflectivity() is the same for all angles.
bool reflects_evenly(const Finish& finish) {
  return !finish.reflection_fresnel && finish.reflection_min == finish.reflection_max &&
         finish.reflection_metallic == 0.0;
}

}  // namespace

PlainTextures::PlainTextures(const Scene& scene)
    : m_settings(scene.settings()), m_paths(scene.needs()),
      m_may_be_clear(m_paths.transparency || m_paths.layers) {}

bool PlainTextures::has_others(const Leaf& leaf) {
  const Shape& shape = leaf.shape();
  return typeid(shape) == typeid(Mesh) && static_cast<const Mesh&>(shape).has_textures();
}

const PlainTextures::Kind& PlainTextures::another(const Texture* texture) {
  const auto [at, is_new] = m_known.try_emplace(texture);
  if (is_new) at->second = made(*texture);
  m_last = texture;
  m_last_kind = &at->second;
  return *m_last_kind;
}

PlainTextures::Kind PlainTextures::made(const Texture& texture) const {
  Kind kind;
  std::vector<const LayeredTexture*> all;
  texture.collect(all);
  for (const LayeredTexture* layered : all) {
    for (const TextureLayer& layer : layered->layers()) {
      kind.may_be_lit = kind.may_be_lit || shows_light(*layer.finish);
      // Where a mirror takes from what passes, the layers below depend on it.
      const bool is_alone = layered->layers().size() == 1;
      kind.is_plain =
          kind.is_plain && is_plain(*layer.finish) && (is_alone || !layer.finish->conserve_energy);
    }
  }
  kind.everywhere = texture.everywhere();
  if (!kind.is_plain || !kind.everywhere || kind.everywhere->layers().size() != 1) return kind;
  const TextureLayer& layer = kind.everywhere->layers().front();
  const Colour* colour = layer.pigment->constant();
  if (colour && !layer.normal) fill(layer, *colour, kind.fixed.emplace());
  return kind;
}

/// All but the normal. The operations and their order are those of SurfaceShading::shade_layer().
[[gnu::always_inline]] inline void PlainTextures::fill(const TextureLayer& layer,
                                                       const Colour& colour,
                                                       PlainLayer& out) const {
  const Finish& finish = *layer.finish;
  const double opacity = m_may_be_clear ? layer_opacity(colour, m_settings) : 1.0;
  out.finish = &finish;
  out.pigment = colour.rgb;
  out.own = times(colour.rgb * finish.ambient * m_settings.ambient_light, opacity);
  out.own += times(colour.rgb * finish.emission, opacity);
  out.diffuse = finish.diffuse * opacity;
  out.passed = m_may_be_clear ? passed(colour) : Rgb(0.0f);
  out.is_turned = layer.normal != nullptr;
  out.is_lit = shows_light(finish);
  out.shines = has_highlights(finish);
  out.reflects = m_paths.reflection && reflects(finish);
  out.mirror.reset();
  if (out.reflects && reflects_evenly(finish)) {
    constexpr double kAnyCosine = 0.5, kAnyIor = 1.0;
    out.mirror = reflectivity(finish, kAnyCosine, kAnyIor, colour.rgb);
  }
}

/// Of a texture by place; null: several blend there. Leads `place` to where it is asked.
const LayeredTexture* PlainTextures::resolved(const Texture& texture, const SurfaceContext& surface,
                                              TexturePlace& place) {
  m_found.clear();
  texture.resolve(place.point, surface, 1.0, m_found);
  if (m_found.size() != 1 || m_found.front().weight != 1.0) return nullptr;
  place = m_found.place(m_found.front());
  return m_found.front().texture;
}

std::size_t PlainTextures::find_layers(const Ray& ray, const Hit& hit, const MetPlace& where,
                                       PlainLayer* out) {
  const Attributes& attributes = hit.leaf->attributes();
  if (attributes.double_illuminate || attributes.lights || may_have_others(*hit.leaf)) return 0;
  const Texture* texture = texture_of(*hit.leaf, where.from_behind);
  const Kind& kind = kind_of(texture);
  if (!kind.is_plain) return 0;
  if (kind.fixed) {
    *out = *kind.fixed;
    out->normal = where.normal;
    return 1;
  }
  SurfaceContext surface{where.point, where.normal, ray.direction, &hit};
  TexturePlace place{texture_point(surface)};
  const LayeredTexture* layered =
      kind.everywhere ? kind.everywhere : resolved(*texture, surface, place);
  if (!layered) return 0;
  const std::vector<TextureLayer>& layers = layered->layers();
  std::size_t count = 0;
  Rgb filter(1.0f);
  double transparency = 1.0;
  for (auto layer = layers.rbegin();
       layer != layers.rend() && transparency > m_settings.adc_bailout; ++layer) {
    if (count == kMostLayers) return 0;
    PlainLayer& added = out[count++];
    if (layer->normal) surface.normal = place.perturbed(*layer->normal, where.normal, surface);
    const Colour* constant = layer->pigment->constant();
    fill(*layer, constant ? *constant : layer->pigment->colour(place.point, surface), added);
    added.normal = layer->normal ? place.outwards(surface.normal) : where.normal;
    filter *= added.passed;
    transparency = std::min(1.0, static_cast<double>(std::fabs(grey(filter))));
  }
  return count;
}

}  // namespace lentray::core
