#include "core/trace/surface_shading.h"

#include <algorithm>
#include <cmath>

#include "core/light/area_light.h"
#include "core/photon/photon_map.h"
#include "core/trace/facing.h"
#include "core/trace/illumination.h"
#include "core/trace/indirect_light.h"
#include "core/trace/photon_light.h"
#include "core/trace/random_key.h"
#include "core/trace/reflectance.h"

namespace lentray::core {
SurfaceShading::SurfaceShading(ThreadContext& context, ShadowTester& shadows,
                               const PathRules& rules)
    : m_context(context), m_photons(surface_photons(context)), m_settings(context.scene.settings()),
      m_rules(rules), m_paths(context.scene.needs()),
      m_lights(context, shadows, rules.area_lights, m_paths.layers) {
  if (context.scene.needs().subsurface && rules.subsurface) {
    m_subsurface = std::make_unique<SubsurfaceLight>(context, shadows, rules);
  }
}

void SurfaceShading::light(const Layer& layer, const Rgb& above, const Surface& at,
                           ShadingBuffers& buffers, Rgb& own) {
  if (layer.finish->subsurface) [[unlikely]]
    own += scattered(layer, above, at, buffers);
  if (m_context.indirect) own += indirectly_lit(layer, above, at, buffers);
  own += lit(layer, at, buffers.lights);
  if (m_photons) own += lit_by_photons(layer, at, buffers);
}

[[gnu::noinline]] Rgb SurfaceShading::indirectly_lit(const Layer& layer, const Rgb& above,
                                                     const Surface& at, ShadingBuffers& buffers) {
  IndirectLight& indirect = *m_context.indirect;
  if (!indirect.is_wanted() || buffers.is_scattered) return {};
  const bool is_first = at.state.kind == RayKind::kGather;
  const auto on_side = [&](double diffuse, std::size_t side) {
    IndirectAnswer& answer = buffers.indirect[side];
    bool& is_known = buffers.is_indirect_known[side];
    const double share = grey(above * layer.pigment) * layer.opacity * diffuse;
    if (!is_known && share > m_rules.adc_bailout) {
      const double sign = side == 0 ? 1.0 : -1.0;
      answer = indirect.at({at.point(), at.normal * sign, layer.normal * sign,
                            at.state.weight * share, at.state.scattered});
      is_known = true;
    }
    if (!is_known) return Rgb();
    indirect.take_share(answer.number,
                        times(layer.pigment * above, layer.opacity * diffuse * at.texture_weight),
                        is_first);
    return times(layer.pigment * answer.light, layer.opacity * diffuse);
  };
  const Finish& finish = *layer.finish;
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

[[gnu::noinline]] Rgb SurfaceShading::scattered(const Layer& layer, const Rgb& above,
                                                const Surface& at, ShadingBuffers& buffers) {
  if (!m_subsurface) return {};
  UnscatteredRay through;
  const Rgb light = m_subsurface->at(at, *layer.finish->subsurface, layer.pigment,
                                     times(above, at.texture_weight), through);
  buffers.is_scattered = m_settings.subsurface->radiosity;
  if (!through.left.is_black()) {
    through.share = above;
    buffers.unscattered.push_back(through);
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
Rgb SurfaceShading::lit(const Layer& layer, const Surface& at, LightsAtPoint& known) {
  if (!layer.is_lit) return {};
  const bool one_sided = !at.attributes.double_illuminate;
  const Facing facing{layer.normal, one_sided, one_sided && layer.finish->diffuse_back == 0.0};
  Receiver receiver{*this,         facing, *layer.finish, layer.pigment,
                    layer.opacity, at,     layer.shines};
  m_lights.at({at.point(), at.level, at.state.tree_place, at.state.inside, at.state.key, false,
               m_photons && collects_photons(at), m_rules.volumes},
              m_lights.lights_of(at.attributes), known, facing, receiver);
  return receiver.sum;
}

bool SurfaceShading::collects_photons(const Surface& at) const {
  return m_context.scene.pass_flags(at.attributes).photon_collect;
}

[[gnu::noinline]] Rgb SurfaceShading::lit_by_photons(const Layer& layer, const Surface& at,
                                                     ShadingBuffers& buffers) {
  if (!layer.is_lit || !collects_photons(at)) return {};
  if (!buffers.has_photons) {
    m_photons->gather(at.point(), &layer.normal, buffers.photons, buffers.more_photons);
    buffers.has_photons = true;
  }
  return light_of_photons(m_photons->tree(), buffers.photons, layer, at, m_settings);
}

Rgb SurfaceShading::film(const Finish& finish, const Vec3& normal, const Vec3& from_light,
                         const Surface& at) const {
  return film_tint(finish, film_thickness(finish, at.point(), m_settings.noise_generator),
                   m_settings.irid_wavelength, normal, from_light, at.ray().direction);
}

}  // namespace lentray::core
