#include "core/trace/surface_shading.h"

#include <algorithm>
#include <cmath>

#include "core/light/area_light.h"
#include "core/photon/photon_map.h"
#include "core/trace/facing.h"
#include "core/trace/illumination.h"
#include "core/trace/indirect_light.h"
#include "core/trace/layer_opacity.h"
#include "core/trace/photon_light.h"
#include "core/trace/random_key.h"
#include "core/trace/reflectance.h"
#include "core/trace/refraction.h"

namespace lentray::core {
namespace {

/// Of what passes a layer that conserves energy.
Rgb left_by_mirror(const Mirror& mirror) {
  const Rgb& c = mirror.colour;
  return {std::min(1.0f, 1.0f - c.r), std::min(1.0f, 1.0f - c.g), std::min(1.0f, 1.0f - c.b)};
}

}  // namespace

SurfaceShading::SurfaceShading(ThreadContext& context, ShadowTester& shadows,
                               const PathRules& rules)
    : m_context(context), m_photons(surface_photons(context)), m_settings(context.scene.settings()),
      m_rules(rules), m_paths(context.scene.needs()),
      m_lights(context, shadows, rules.area_lights, m_paths.layers) {
  if (context.scene.needs().subsurface && rules.subsurface) {
    m_subsurface = std::make_unique<SubsurfaceLight>(context, shadows, rules);
  }
}

void SurfaceShading::shade(const LayeredTexture& texture, Surface& at, ShadingBuffers& buffers,
                           LayerSum& sum) {
  const auto& layers = texture.layers();
  if (m_paths.reflection && buffers.mirrors.size() < layers.size()) {
    buffers.mirrors.resize(layers.size());
  }
  for (auto layer = layers.rbegin();
       layer != layers.rend() && sum.transparency > m_rules.adc_bailout; ++layer) {
    shade_layer(*layer, at, sum, buffers);
    ++sum.layers;
    ++at.layer;
  }
}

void SurfaceShading::shade_layer(const TextureLayer& layer, Surface& at, LayerSum& sum,
                                 ShadingBuffers& buffers) {
  const Finish& finish = *layer.finish;
  if (layer.normal) {
    at.context.normal = at.texture_place.perturbed(*layer.normal, at.normal, at.context);
  }
  const Colour* constant = layer.pigment->constant();
  const Colour colour =
      constant ? *constant : layer.pigment->colour(at.texture_place.point, at.context);
  const Vec3 normal = layer.normal ? at.texture_place.outwards(at.context.normal) : at.normal;
  if (m_paths.transparency && sum.layers == 0) {
    sum.top_normal = normal;
    sum.top_finish = &finish;
  }
  if (m_paths.reflection) {
    buffers.mirrors[sum.layers] = mirror_of(finish, colour.rgb, normal, at, sum.transparency);
  }

  const bool may_be_clear = m_paths.transparency || m_paths.layers;
  const double opacity = may_be_clear ? layer_opacity(colour, m_settings) : 1.0;
  Rgb own = times(colour.rgb * finish.ambient * m_settings.ambient_light, opacity);
  own += times(colour.rgb * finish.emission, opacity);
  if (finish.subsurface) [[unlikely]]
    own += scattered(*finish.subsurface, colour.rgb, at, sum, buffers);
  if (m_context.indirect) {
    own += indirectly_lit(finish, colour.rgb, normal, opacity, at, buffers, sum);
  }
  own += lit(finish, colour.rgb, normal, opacity, at, buffers.lights);
  if (m_photons) own += lit_by_photons(finish, colour.rgb, normal, opacity, at, sum, buffers);
  sum.light += own * sum.filter;

  if (may_be_clear) {
    sum.filter *= passed(colour);
    if (m_paths.reflection && finish.conserve_energy) {
      sum.filter *= left_by_mirror(buffers.mirrors[sum.layers]);
    }
    sum.transparency = std::min(1.0, static_cast<double>(std::fabs(grey(sum.filter))));
  } else {
    sum.transparency = 0.0;
  }
}

[[gnu::always_inline]] inline Mirror SurfaceShading::mirror_with(const Reflectivity& share,
                                                                 const Finish& finish,
                                                                 const Vec3& normal,
                                                                 const Surface& at,
                                                                 double transparency) const {
  Mirror mirror;
  mirror.normal = normal;
  mirror.colour = share.colour;
  mirror.weight = static_cast<float>(at.state.weight * transparency) * share.weight;
  mirror.exponent = 1.0 / finish.reflection_exponent;
  mirror.finish = &finish;
  return mirror;
}

Mirror SurfaceShading::mirror_of(const Finish& finish, const Rgb& pigment, const Vec3& normal,
                                 const Surface& at, double transparency) const {
  if (!reflects(finish)) return {};
  const double cosine = -dot(at.ray().direction, normal);
  const double ior = finish.reflection_fresnel
                         ? relative_ior(at.interior(), m_context.interiors, at.state.inside,
                                        m_settings.atmosphere_ior)
                         : 1.0;
  return mirror_with(reflectivity(finish, cosine, ior, pigment), finish, normal, at, transparency);
}

[[gnu::noinline]] Rgb SurfaceShading::indirectly_lit(const Finish& finish, const Rgb& pigment,
                                                     const Vec3& normal, double opacity,
                                                     const Surface& at, ShadingBuffers& buffers,
                                                     LayerSum& sum) {
  IndirectLight& indirect = *m_context.indirect;
  if (!indirect.is_wanted() || sum.is_scattered) return {};
  const bool is_first = at.state.kind == RayKind::kGather;
  const auto on_side = [&](double diffuse, std::size_t side) {
    IndirectAnswer& answer = buffers.indirect[side];
    bool& is_known = sum.is_indirect_known[side];
    const double share = grey(sum.filter * pigment) * opacity * diffuse;
    if (!is_known && share > m_rules.adc_bailout) {
      const double sign = side == 0 ? 1.0 : -1.0;
      answer = indirect.at({at.point(), at.normal * sign, normal * sign, at.state.weight * share,
                            at.state.scattered});
      is_known = true;
    }
    if (!is_known) return Rgb();
    indirect.take_share(answer.number,
                        times(pigment * sum.filter, opacity * diffuse * at.texture_weight),
                        is_first);
    return times(pigment * answer.light, opacity * diffuse);
  };
  double diffuse = finish.diffuse / finish.albedo_factor;
  double diffuse_back = finish.diffuse_back / finish.albedo_factor;
  if (finish.subsurface) {
    diffuse = finish.subsurface->diffuse;
    diffuse_back = finish.subsurface->diffuse_back;
  }
  Rgb light = on_side(diffuse, 0);
  if (diffuse_back != 0.0) light += on_side(diffuse_back, 1);
  return light;
}

[[gnu::noinline]] Rgb SurfaceShading::scattered(const SubsurfaceFinish& finish, const Rgb& pigment,
                                                const Surface& at, LayerSum& sum,
                                                ShadingBuffers& buffers) {
  if (!m_subsurface) return {};
  UnscatteredRay through;
  const Rgb light =
      m_subsurface->at(at, finish, pigment, times(sum.filter, at.texture_weight), through);
  sum.is_scattered = m_settings.subsurface->radiosity;
  if (!through.left.is_black()) {
    through.share = sum.filter;
    buffers.unscattered.push_back(through);
    sum.is_seen_through = true;
  }
  return light;
}

/// Which lights a layer wants.
struct SurfaceShading::Facing {
  const Vec3 normal;
  const bool one_sided, front_only;

  bool is_behind(double cosine) const { return one_sided && cosine < kGrazing; }
  bool may_face(const LightSource& source, const Vec3& to) const {
    return !(front_only && source.surely_behind(to, normal));
  }
  bool faces(const LightSource& source, const Vec3& direction) const {
    return !(front_only && is_behind(dot(normal, direction))) || source.has_points;
  }
};

/// Sums what a layer makes of the lights that arrive.
struct SurfaceShading::Receiver {
  SurfaceShading& shading;
  const Facing& facing;
  const Finish& finish;
  const Rgb& pigment;
  const double opacity;
  const Surface& surface;
  const bool shines;
  Rgb sum{};

  [[gnu::always_inline]] void receive(const IncomingLight& light) {
    if (light.source->has_points) [[unlikely]]
      return receive_points(light);
    receive_from(*light.source, light.ray, light.colour);
  }
  /// False: no part of the light, nor what strengthens it less than 1e10 times, changes the sum.
  bool may_show(const IncomingLight& light) const {
    if (light.source->has_points || finish.crand > 0.0) return true;
    const double cosine = dot(facing.normal, light.ray.direction);
    const bool behind = facing.is_behind(cosine);
    const double diffuse = behind ? finish.diffuse_back : finish.diffuse;
    if (diffuse > 0.0 && diffuse * opacity != 0.0) return true;
    if (!shines || light.source->shadowless || behind) return false;
    return may_shine(finish, {light.ray.direction, surface.ray().direction, facing.normal,
                              light.colour, pigment});
  }
  /// Of each point of an area light, with the shadow that all of the light has.
  [[gnu::noinline]] void receive_points(const IncomingLight& all) {
    const LightSource& source = *all.source;
    const AreaLight& area = source.light.area;
    const AreaAxes axes = area_axes(area, all.ray.direction);
    const Rgb share = all.colour * (1.0f / static_cast<float>(area.size1 * area.size2));
    RandomSequence places(key_of(source), RandomSequence::Use::kLightPoints);
    for (int v = 0; v < area.size2; ++v) {
      for (int u = 0; u < area.size1; ++u) {
        const Vec3 offset = jittered_area_offset(area, axes, u, v, [&] { return places.next(); });
        const LightRay one = light_ray(source.light, surface.point(), offset);
        if (facing.front_only && facing.is_behind(dot(facing.normal, one.direction))) continue;
        receive_from(
            source, one,
            share * static_cast<float>(light_attenuation(source.light, surface.point(), one)),
            static_cast<std::uint32_t>(v * area.size1 + u));
      }
    }
  }
  /// The key of what is random about a light on this layer.
  std::uint64_t key_of(const LightSource& source) const {
    return branch_key(branch_key(surface.state.key, surface.layer), source.index);
  }
  double grain(const LightSource& source, std::uint32_t point) const {
    return RandomSequence(branch_key(key_of(source), point), RandomSequence::Use::kCrand).next();
  }
  [[gnu::always_inline]] void receive_from(const LightSource& source, const LightRay& ray,
                                           const Rgb& light, std::uint32_t point = 0) {
    const double cosine = dot(facing.normal, ray.direction);
    const bool behind = facing.is_behind(cosine);
    Rgb share =
        diffuse_light(finish, cosine, light, pigment, behind ? finish.diffuse_back : finish.diffuse,
                      opacity, finish.crand > 0.0 ? grain(source, point) : 0.0);
    if (shines && !source.shadowless && !behind) {
      share += highlights(finish,
                          {ray.direction, surface.ray().direction, facing.normal, light, pigment});
    }
    if (finish.irid > 0.0) share *= shading.film(finish, facing.normal, ray.direction, surface);
    sum += share;
  }
};

/// Diffuse light and highlights of all lights.
Rgb SurfaceShading::lit(const Finish& finish, const Rgb& pigment, const Vec3& normal,
                        double opacity, const Surface& at, LightsAtPoint& known) {
  if (!m_rules.lights) return {};
  if (!shows_light(finish)) return {};
  const bool one_sided = !at.attributes.double_illuminate;
  const Facing facing{normal, one_sided, one_sided && finish.diffuse_back == 0.0};
  Receiver receiver{
      *this, facing, finish, pigment, opacity, at, m_rules.highlights && has_highlights(finish)};
  m_lights.at({at.point(), at.level, at.state.tree_place, at.state.inside, at.state.key, false,
               m_photons && collects_photons(at), m_rules.volumes},
              m_lights.lights_of(at.attributes), known, facing, receiver);
  return receiver.sum;
}

void SurfaceShading::find_mirrors(std::span<const PlainLayer> layers, const Surface& at,
                                  ShadingBuffers& buffers, LayerSum& sum) const {
  if (!m_paths.reflection) return;
  if (buffers.mirrors.size() < layers.size()) buffers.mirrors.resize(layers.size());
  LayerSum above;
  for (std::size_t i = 0; i < layers.size(); ++i) {
    const PlainLayer& layer = layers[i];
    const double clear = above.transparency;
    buffers.mirrors[i] = layer.mirror
                             ? mirror_with(*layer.mirror, *layer.finish, layer.normal, at, clear)
                             : mirror_of(*layer.finish, layer.pigment, layer.normal, at, clear);
    add_plain(layer, {}, above);
  }
  if (!layers.front().finish->conserve_energy) return;
  sum.filter *= left_by_mirror(buffers.mirrors.front());
  sum.transparency = std::min(1.0, static_cast<double>(std::fabs(grey(sum.filter))));
}

bool SurfaceShading::collects_photons(const Surface& at) const {
  return m_context.scene.pass_flags(at.attributes).photon_collect;
}

[[gnu::noinline]] Rgb SurfaceShading::lit_by_photons(const Finish& finish, const Rgb& pigment,
                                                     const Vec3& normal, double opacity,
                                                     const Surface& at, LayerSum& sum,
                                                     ShadingBuffers& buffers) {
  if (!m_rules.lights || !shows_light(finish) || !collects_photons(at)) return {};
  if (!sum.has_photons) {
    m_photons->gather(at.point(), &normal, buffers.photons, buffers.more_photons);
    sum.has_photons = true;
  }
  const bool shines = m_rules.highlights && has_highlights(finish);
  return light_of_photons(m_photons->tree(), buffers.photons,
                          {finish, pigment, normal, opacity, shines, at}, m_settings);
}

Rgb SurfaceShading::film(const Finish& finish, const Vec3& normal, const Vec3& from_light,
                         const Surface& at) const {
  return film_tint(finish, film_thickness(finish, at.point(), m_settings.noise_generator),
                   m_settings.irid_wavelength, normal, from_light, at.ray().direction);
}

}  // namespace lentray::core
