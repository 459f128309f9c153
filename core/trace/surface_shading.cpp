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
      m_rules(rules), m_lights(context, shadows, rules.area_lights) {
  if (context.scene.needs().subsurface && rules.subsurface) {
    m_subsurface = std::make_unique<SubsurfaceLight>(context, shadows, rules);
  }
}

void SurfaceShading::light(const Layer& layer, const Rgb& above, const Surface& at,
                           ShadingBuffers& buffers, Rgb& own) {
  if (layer.finish->subsurface) [[unlikely]]
    own += scattered(layer, above, at, buffers);
  if (m_context.indirect) own += indirectly_lit(layer, above, at, buffers);
  own += buffers.lit[at.layer];
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

/// The layers of a surface: which lights they want, and the sum of what each makes of those that arrive. `kOne`: it is
/// one, which is lit.
template <bool kOne>
struct SurfaceShading::LitLayers {
  LitLayers(const SurfaceShading& s, Layers l, const Surface& at)
      : shading(s), layers(l), surface(at), one_sided(!at.attributes.double_illuminate),
        first_is_front_only(one_sided && l.front().finish->diffuse_back == 0.0) {}
  const SurfaceShading& shading;
  const Layers layers;
  const Surface& surface;
  const bool one_sided;
  const bool first_is_front_only;
  Rgb first_sum;        ///< of the only one
  Rgb* sums = nullptr;  ///< of several

  bool is_behind(double cosine) const { return one_sided && cosine < kGrazing; }
  bool front_only(const Layer& layer) const {
    if constexpr (kOne) return first_is_front_only;
    return one_sided && layer.finish->diffuse_back == 0.0;
  }
  bool faces(const Layer& layer, const Vec3& direction) const {
    return !(front_only(layer) && is_behind(dot(layer.normal, direction)));
  }
  template <class Wants>
  [[gnu::always_inline]] bool any(const Wants& wants) const {
    if constexpr (kOne) return wants(layers.front());
    for (const Layer& layer : layers) {
      if (layer.is_lit && wants(layer)) return true;
    }
    return false;
  }

  bool may_face(const LightSource& source, const Vec3& to) const {
    return any([&](const Layer& layer) {
      return !(front_only(layer) && source.surely_behind(to, layer.normal));
    });
  }
  bool faces(const LightSource& source, const Vec3& direction) const {
    return any([&](const Layer& layer) { return source.has_points || faces(layer, direction); });
  }
  /// False: no part of the light, nor what strengthens it less than 1e10 times, changes a sum.
  bool may_show(const IncomingLight& light) const {
    return any([&](const Layer& layer) { return may_show(layer, light); });
  }
  bool may_show(const Layer& layer, const IncomingLight& light) const {
    const Finish& finish = *layer.finish;
    if (light.source->has_points || finish.crand > 0.0) return true;
    const double cosine = dot(layer.normal, light.ray.direction);
    const bool behind = is_behind(cosine);
    const double diffuse = behind ? finish.diffuse_back : finish.diffuse;
    if (diffuse > 0.0 && diffuse * layer.opacity != 0.0) return true;
    if (!layer.shines || light.source->shadowless || behind) return false;
    return may_shine(finish, {light.ray.direction, surface.ray().direction, layer.normal,
                              light.colour, layer.pigment});
  }

  [[gnu::always_inline]] void receive(const IncomingLight& light) {
    if (light.source->has_points) [[unlikely]]
      return receive_points(light);
    receive(*light.source, light.ray, light.colour, 0);
  }
  /// Of each point of an area light, with the shadow that all of the light has.
  [[gnu::noinline]] void receive_points(const IncomingLight& all) {
    const LightSource& source = *all.source;
    const AreaLight& area = source.light.area;
    const AreaAxes axes = area_axes(area, all.ray.direction);
    const Rgb share = all.colour * (1.0f / static_cast<float>(area.size1 * area.size2));
    for (const Layer& layer : layers) {
      if (!layer.is_lit) continue;
      RandomSequence places(key_of(layer, source), RandomSequence::Use::kLightPoints);
      for (int v = 0; v < area.size2; ++v) {
        for (int u = 0; u < area.size1; ++u) {
          const Vec3 offset = jittered_area_offset(area, axes, u, v, [&] { return places.next(); });
          const LightRay one = light_ray(source.light, surface.point(), offset);
          if (!faces(layer, one.direction)) continue;
          receive(layer, source, one,
                  share * static_cast<float>(light_attenuation(source.light, surface.point(), one)),
                  static_cast<std::uint32_t>(v * area.size1 + u));
        }
      }
    }
  }
  [[gnu::always_inline]] void receive(const LightSource& source, const LightRay& ray,
                                      const Rgb& light, std::uint32_t point) {
    if constexpr (kOne) return receive(layers.front(), source, ray, light, point);
    for (const Layer& layer : layers) {
      if (layer.is_lit && faces(layer, ray.direction)) receive(layer, source, ray, light, point);
    }
  }
  [[gnu::always_inline]] void receive(const Layer& layer, const LightSource& source,
                                      const LightRay& ray, const Rgb& light, std::uint32_t point) {
    const Finish& finish = *layer.finish;
    const double cosine = dot(layer.normal, ray.direction);
    const bool behind = is_behind(cosine);
    Rgb share = diffuse_light(finish, cosine, light, layer.pigment,
                              behind ? finish.diffuse_back : finish.diffuse, layer.opacity,
                              finish.crand > 0.0 ? grain(layer, source, point) : 0.0);
    if (layer.shines && !source.shadowless && !behind) {
      share += highlights(
          finish, {ray.direction, surface.ray().direction, layer.normal, light, layer.pigment});
    }
    if (finish.irid > 0.0) share *= shading.film(finish, layer.normal, ray.direction, surface);
    (kOne ? first_sum : sums[number(layer)]) += share;
  }
  std::size_t number(const Layer& layer) const {
    return static_cast<std::size_t>(&layer - layers.data());
  }
  /// The key of what is random about a light on a layer.
  std::uint64_t key_of(const Layer& layer, const LightSource& source) const {
    return branch_key(branch_key(surface.state.key, number(layer)), source.index);
  }
  double grain(const Layer& layer, const LightSource& source, std::uint32_t point) const {
    return RandomSequence(branch_key(key_of(layer, source), point), RandomSequence::Use::kCrand)
        .next();
  }
};

void SurfaceShading::find_lit(Layers layers, const Surface& at, ShadingBuffers& buffers) {
  if (buffers.lit.size() < layers.size()) buffers.lit.resize(layers.size());
  if (layers.size() == 1 && layers.front().is_lit) return find_lit<true>(layers, at, buffers);
  std::fill_n(buffers.lit.begin(), layers.size(), Rgb());
  if (std::ranges::any_of(layers, &Layer::is_lit)) find_lit<false>(layers, at, buffers);
}

template <bool kOne>
[[gnu::always_inline]] inline void SurfaceShading::find_lit(Layers layers, const Surface& at,
                                                            ShadingBuffers& buffers) {
  LitLayers<kOne> lit(*this, layers, at);
  lit.sums = buffers.lit.data();
  m_lights.at({at.point(), at.level, at.state.tree_place, at.state.inside, at.state.key, false,
               m_photons && collects_photons(at), m_rules.volumes},
              m_lights.lights_of(at.attributes), buffers.lights, lit, lit);
  if constexpr (kOne) buffers.lit.front() = lit.first_sum;
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
