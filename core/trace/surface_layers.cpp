#include "core/trace/surface_layers.h"

#include <algorithm>
#include <cmath>
#include <typeinfo>

#include "core/shape/mesh.h"
#include "core/trace/layer_opacity.h"
#include "core/trace/refraction.h"
#include "core/trace/surface_textures.h"
#include "core/trace/thread_context.h"

namespace lentray::core {
namespace {

/// Whether core/trace/plain_lights.h can light it.
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

void set_below(const Rgb& below, Layer& layer) {
  layer.below = below;
  layer.clear = std::min(1.0, static_cast<double>(std::fabs(grey(below))));
}

/// Takes from what passes what its mirror keeps.
void conserve_energy(Layer& layer) {
  const Rgb& c = layer.mirror.colour;
  set_below(layer.below * Rgb(std::min(1.0f, 1.0f - c.r), std::min(1.0f, 1.0f - c.g),
                              std::min(1.0f, 1.0f - c.b)),
            layer);
}

}  // namespace

SurfaceLayers::SurfaceLayers(const ThreadContext& context, const PathRules& rules)
    : m_context(context), m_settings(context.scene.settings()), m_rules(rules),
      m_paths(context.scene.needs()), m_may_be_clear(m_paths.transparency || m_paths.layers) {}

bool SurfaceLayers::has_others(const Leaf& leaf) {
  const Shape& shape = leaf.shape();
  return typeid(shape) == typeid(Mesh) && static_cast<const Mesh&>(shape).has_textures();
}

const SurfaceLayers::Kind& SurfaceLayers::another(const Texture* texture) {
  const auto [at, is_new] = m_known.try_emplace(texture);
  if (is_new) at->second = made(*texture);
  m_asked[place_of(texture)] = {texture, &at->second};
  return at->second;
}

SurfaceLayers::Kind SurfaceLayers::made(const Texture& texture) const {
  Kind kind;
  std::vector<const LayeredTexture*> all;
  texture.collect(all);
  for (const LayeredTexture* layered : all) {
    for (const TextureLayer& layer : layered->layers()) {
      kind.may_be_lit = kind.may_be_lit || shows_light(*layer.finish);
      kind.is_plain = kind.is_plain && is_plain(*layer.finish);
    }
  }
  kind.everywhere = texture.everywhere();
  if (!kind.everywhere || kind.everywhere->layers().size() != 1) return kind;
  const TextureLayer& only = kind.everywhere->layers().front();
  const Colour* constant = only.pigment->constant();
  if (!constant || only.normal) return kind;
  Layer& layer = kind.fixed.emplace();
  fill(only, *constant, layer);
  pass(*constant, Rgb(1.0f), layer);
  layer.mirror = {};
  if (m_paths.reflection && reflects(*layer.finish) && reflects_evenly(*layer.finish)) {
    constexpr double kAnyCosine = 0.5, kAnyIor = 1.0;
    layer.mirror = reflectivity(*layer.finish, kAnyCosine, kAnyIor, layer.pigment);
  }
  return kind;
}

[[gnu::always_inline]] inline void SurfaceLayers::fill(const TextureLayer& layer,
                                                       const Colour& colour, Layer& out) const {
  const Finish& finish = *layer.finish;
  out.finish = &finish;
  out.pigment = colour.rgb;
  out.opacity = m_may_be_clear ? layer_opacity(colour, m_settings) : 1.0;
  out.own = times(colour.rgb * finish.ambient * m_settings.ambient_light, out.opacity);
  out.own += times(colour.rgb * finish.emission, out.opacity);
  out.diffuse = finish.diffuse * out.opacity;
  out.is_turned = layer.normal != nullptr;
  out.is_lit = m_rules.lights && shows_light(finish);
  out.shines = m_rules.highlights && has_highlights(finish);
}

[[gnu::always_inline]] inline void SurfaceLayers::pass(const Colour& colour, const Rgb& above,
                                                       Layer& out) const {
  set_below(above * (m_may_be_clear ? passed(colour) : Rgb(0.0f)), out);
}

[[gnu::always_inline]] inline Reflectivity SurfaceLayers::mirror_of(const Layer& layer,
                                                                    const Eye& eye) const {
  if (!m_paths.reflection || !reflects(*layer.finish)) return {};
  return seen_mirror(layer, eye);
}

Reflectivity SurfaceLayers::seen_mirror(const Layer& layer, const Eye& eye) const {
  const Finish& finish = *layer.finish;
  const double ior = finish.reflection_fresnel
                         ? relative_ior(interior_of(eye.hit.leaf->attributes(), eye.hit.object),
                                        m_context.interiors, eye.inside, m_settings.atmosphere_ior)
                         : 1.0;
  return reflectivity(finish, -dot(eye.ray.direction, layer.normal), ior, layer.pigment);
}

PlaceLayers SurfaceLayers::find(const RayState& state, const Hit& hit, const MetPlace& where,
                                LayerBuffer& out) {
  PlaceLayers found;
  found.first = static_cast<std::uint32_t>(out.layers.size());
  const Eye eye{state.ray, hit, where.normal, state.inside};
  const Attributes& attributes = hit.leaf->attributes();
  const auto surface = [&] {
    return SurfaceContext{where.point, where.normal, state.ray.direction, &hit};
  };
  if (!may_have_others(*hit.leaf)) {
    const Kind& kind = kind_of(texture_of(*hit.leaf, where.from_behind));
    found.is_plain = kind.is_plain && !attributes.double_illuminate && !attributes.lights;
    if (kind.fixed && 1.0 > m_rules.adc_bailout) {
      Layer& layer = out.layers.emplace_back(*kind.fixed);
      layer.normal = where.normal;
      if (layer.mirror.colour.is_black()) layer.mirror = mirror_of(layer, eye);
      if (layer.finish->conserve_energy) conserve_energy(layer);
      found.count = 1;
      return found;
    }
    if (kind.everywhere) {
      SurfaceContext context = surface();
      find_in(*kind.everywhere, {texture_point(context)}, eye, context, out.layers);
      found.count = static_cast<std::uint32_t>(out.layers.size()) - found.first;
      return found;
    }
  }
  SurfaceContext context = surface();
  find_blended(eye, where, context, found, out);
  found.count = static_cast<std::uint32_t>(out.layers.size()) - found.first;
  return found;
}

/// Of textures by place.
void SurfaceLayers::find_blended(const Eye& eye, const MetPlace& where, SurfaceContext& surface,
                                 PlaceLayers& found, LayerBuffer& out) {
  m_found.clear();
  textures_at(surface, where.from_behind, m_rules.adc_bailout, m_found);
  if (m_found.size() == 1 && m_found.front().weight == 1.0) {
    const WeightedTexture& one = m_found.front();
    return find_in(*one.texture, m_found.place(one), eye, surface, out.layers);
  }
  found.first_part = static_cast<std::uint32_t>(out.parts.size());
  found.parts = static_cast<std::uint32_t>(m_found.size());
  for (const WeightedTexture& texture : m_found) {
    surface.normal = where.normal;
    const std::size_t before = out.layers.size();
    find_in(*texture.texture, m_found.place(texture), eye, surface, out.layers);
    out.parts.push_back({texture.weight, static_cast<std::uint32_t>(out.layers.size() - before)});
  }
}

void SurfaceLayers::find_in(const LayeredTexture& texture, const TexturePlace& place,
                            const Eye& eye, SurfaceContext& surface,
                            std::vector<Layer>& out) const {
  const std::vector<TextureLayer>& layers = texture.layers();
  Rgb above(1.0f);
  double clear = 1.0;
  for (auto layer = layers.rbegin(); layer != layers.rend() && clear > m_rules.adc_bailout;
       ++layer) {
    if (layer->normal) surface.normal = place.perturbed(*layer->normal, eye.normal, surface);
    const Colour* constant = layer->pigment->constant();
    Colour seen;
    if (constant) {
      seen = *constant;
    } else if (!eye.is_photon || layer->finish->reflection_metallic != 0.0 ||
               !layer->pigment->is_opaque()) {
      seen = layer->pigment->colour(place.point, surface);
    }
    if (eye.is_photon) seen.rgb *= above;
    Layer& added = out.emplace_back();
    fill(*layer, seen, added);
    added.normal = layer->normal ? place.outwards(surface.normal) : eye.normal;
    added.mirror = mirror_of(added, eye);
    pass(seen, above, added);
    if (added.finish->conserve_energy) conserve_energy(added);
    above = added.below;
    clear = added.clear;
  }
}

}  // namespace lentray::core
