#include "core/trace/ray_stepper.h"

#include <algorithm>
#include <cmath>

#include "core/base/tiny.h"
#include "core/scene/tolerances.h"
#include "core/trace/random_key.h"
#include "core/trace/reflectance.h"
#include "core/trace/refraction.h"
#include "core/trace/spectrum.h"
#include "core/trace/surface_textures.h"

namespace lentray::core {
namespace {

std::uint32_t next_place(std::uint32_t tree_place) { return std::min(tree_place, kTreePlaces - 1); }

}  // namespace

RayStepper::RayStepper(ThreadContext& context, ShadowTester& shadows, const PathRules& rules)
    : m_context(context), m_scene(context.scene), m_paths(m_scene.needs()),
      m_hierarchy(m_scene.hierarchy()), m_shading(context, shadows, rules),
      m_max_level(m_scene.settings().max_trace_level), m_bailout(rules.adc_bailout),
      m_min_distance(kMinHitDistance * m_scene.tolerance_scale()),
      m_atmosphere_ior(m_scene.settings().atmosphere_ior),
      m_mirror_images(m_scene.settings().mirror_images),
      m_air(m_scene.needs().atmosphere && rules.volumes ? &m_scene.atmosphere() : nullptr) {
  if (m_scene.needs().media && rules.volumes)
    m_media = std::make_unique<MediaLight>(context, shadows);
  if (m_scene.needs().interiors) m_start_interiors = std::make_unique<StartInteriors>(m_scene);
}

void RayStepper::pass_open_air(const RayState& state, const RayRecord& record, Radiance& light) {
  if (!m_context.interiors.is_hollow(state.inside)) return;
  const Segment segment{state.ray, record.length};
  if (!m_air->rainbows.empty()) pass_rainbows(*m_air, segment, state.key, light);
  if (!m_air->media.empty()) {
    m_media->pass_air(state, record.length, record.level, record.attributes, light);
  }
  if (!m_air->fogs.empty()) pass_fogs(*m_air, segment, light);
}

[[gnu::always_inline]] inline void RayStepper::add_onward(const LayerSum& sum, const Surface& at,
                                                          const ShadingBuffers& buffers,
                                                          RayRecord& record) {
  bool total_reflection = false;
  if (m_paths.transparency && sum.transparency > m_bailout) {
    total_reflection = add_transmitted(sum, at, record);
  }
  if (m_paths.reflection) add_mirrors(sum, total_reflection, at, buffers, record);
}

[[gnu::always_inline]] inline Radiance RayStepper::shade_texture(const LayeredTexture& texture,
                                                                 Surface& at,
                                                                 ShadingBuffers& buffers,
                                                                 RayRecord& record) {
  LayerSum sum;
  m_shading.shade(texture, at, buffers, sum);
  add_onward(sum, at, buffers, record);
  if (sum.is_seen_through) [[unlikely]]
    add_unscattered(at, buffers, record);
  return {sum.light};
}

namespace {

Surface surface_at(const RayState& state, const Hit& hit, const MetPlace& where,
                   const RayRecord& record) {
  return {state,
          *record.attributes,
          {where.point, where.normal, state.ray.direction, &hit},
          where.normal,
          {where.point},
          1.0,
          record.level,
          0,
          where.from_behind};
}

}  // namespace

void RayStepper::go_on(const RayState& state, const Hit& hit, const MetPlace& where,
                       std::span<const PlainLayer> layers, LayerSum& sum, RayRecord& record) {
  const Surface at = surface_at(state, hit, where, record);
  if (m_buffers.empty()) add_buffers();
  ShadingBuffers& buffers = *m_buffers.front();
  m_shading.find_mirrors(layers, at, buffers, sum);
  sum.top_normal = layers.front().normal;
  sum.top_finish = layers.front().finish;
  sum.layers = layers.size();
  add_onward(sum, at, buffers, record);
}

void RayStepper::shade(const RayState& state, const Hit& hit, const MetPlace& where,
                       const BlockLights* block, std::size_t place, RayRecord& record) {
  Surface at = surface_at(state, hit, where, record);
  if (at.attributes.uv_mapping) at.texture_place.point = texture_point(at.context);
  ShadingBuffers& buffers = m_shaded < m_buffers.size() ? *m_buffers[m_shaded] : add_buffers();
  ++m_shaded;
  m_shading.begin(at, block, place, buffers);
  if (m_paths.layers) {
    shade_textures(at, buffers, record);
  } else {
    record.own = shade_texture(*at.attributes.texture->everywhere(), at, buffers, record);
  }
  --m_shaded;
}

ShadingBuffers& RayStepper::add_buffers() {
  m_buffers.push_back(std::make_unique<ShadingBuffers>(m_shading.lights()));
  return *m_buffers.back();
}

void RayStepper::shade_textures(Surface& at, ShadingBuffers& buffers, RayRecord& record) {
  const WeightedTextures& textures = buffers.textures;
  textures_at(at.context, at.from_behind, m_bailout, buffers.textures);
  if (textures.size() == 1 && textures.front().weight == 1.0) {
    at.texture_place = textures.place(textures.front());
    record.own = shade_texture(*textures.front().texture, at, buffers, record);
    return;
  }
  record.own = {};
  for (const WeightedTexture& texture : textures) {
    at.context.normal = at.normal;
    at.texture_place = textures.place(texture);
    at.texture_weight = texture.weight;
    const std::size_t before = record.onward.size();
    const Radiance own = shade_texture(*texture.texture, at, buffers, record);
    record.parts.push_back({own, texture.weight, record.onward.size() - before});
  }
}

[[gnu::always_inline]] inline OnwardRay& RayStepper::add_ray(const Surface& at, float weight,
                                                             RayRecord& record) {
  const std::size_t branch = record.onward.size();
  OnwardRay& onward = record.onward.emplace_back();
  onward.tinted = false;
  onward.state.ray.origin = at.point();
  onward.state.key = branch_key(at.state.key, branch);
  onward.state.wavelength = at.state.wavelength;
  onward.state.weight = weight;
  onward.state.level = at.level;
  onward.state.scattered = at.state.scattered;
  return onward;
}

void RayStepper::add_mirrors(const LayerSum& sum, bool total_reflection, const Surface& at,
                             const ShadingBuffers& buffers, RayRecord& record) {
  for (std::size_t i = 0; m_mirror_images && i < sum.layers; ++i) {
    const Mirror& mirror = buffers.mirrors[i];
    if (mirror.colour.is_black()) continue;
    if (total_reflection && nearly_equal(sum.top_normal, mirror.normal)) continue;
    ++m_context.counters.reflected_rays;
    if (is_cut(at.level, mirror.weight)) continue;
    OnwardRay& image = add_ray(at, mirror.weight, record);
    image.way = OnwardRay::Way::kMirror;
    image.share = mirror.colour;
    image.exponent = mirror.exponent;
    reflect(mirror.normal, *mirror.finish, at, image);
  }
}

/// What translucent layers let through without scattering it. These rays lie in no interior.
[[gnu::noinline]] void RayStepper::add_unscattered(const Surface& at, ShadingBuffers& buffers,
                                                   RayRecord& record) {
  for (const UnscatteredRay& through : buffers.unscattered) {
    const float weight = greatest(through.left);
    if (is_cut(at.level, weight)) continue;
    OnwardRay& onward = add_ray(at, weight, record);
    onward.way = OnwardRay::Way::kMirror;  // added as such an image is
    onward.share = through.left * through.share;
    onward.exponent = 1.0;
    onward.state.ray = through.ray;
    onward.state.wavelength = RayState::kWhite;
    onward.state.tree_place = next_place(2 * at.state.tree_place + 1);
    onward.state.kind = RayKind::kTransmitted;
    onward.state.scattered = static_cast<std::uint8_t>(at.state.scattered + 1);
  }
  buffers.unscattered.clear();
}

void RayStepper::reflect(const Vec3& normal, const Finish& film, const Surface& at,
                         OnwardRay& onward) {
  RayState& state = onward.state;
  state.ray.direction = normalized(mirrored(at.ray().direction, normal, at.normal));
  state.inside = at.state.inside;
  state.tree_place = next_place(2 * at.state.tree_place);
  state.kind = reflected(at.state.kind);
  state.wavelength = at.state.wavelength;
  onward.tinted = film.irid > 0.0;
  if (onward.tinted) onward.tint = m_shading.film(film, normal, state.ray.direction, at);
}

bool RayStepper::add_transmitted(const LayerSum& sum, const Surface& at, RayRecord& record) {
  const Rgb& filter = sum.filter;
  const float most = greatest({std::fabs(filter.r), std::fabs(filter.g), std::fabs(filter.b)});
  const InteriorEntry interior = at.interior();
  InteriorsId inside = at.state.inside;
  const Bend bend =
      m_start_interiors ? enter(interior, m_atmosphere_ior, m_context.interiors, inside) : Bend();
  Rgb fade(1.0f);
  if (interior.interior) {
    fade = Rgb(interior.interior->passed);
    if (m_context.interiors.contains(at.state.inside, interior.key)) {
      fade *= fade_in_interior(*interior.interior, at.hit().t);
    }
  }
  const auto add_through = [&]() -> OnwardRay& {
    OnwardRay& through = add_ray(at, at.state.weight * most, record);
    through.way = OnwardRay::Way::kThrough;
    through.share = fade;
    through.filter = filter;
    through.clear = sum.transparency;
    through.state.inside = inside;
    through.state.tree_place = next_place(2 * at.state.tree_place + 1);
    through.state.kind = transmitted(at.state.kind);
    return through;
  };

  const bool disperses = !(std::fabs(bend.dispersion - 1.0) < kTiny);
  if (disperses && at.state.wavelength == RayState::kWhite) {
    for (int band = 0; band < bend.bands; ++band) {
      OnwardRay& through = add_through();
      through.way = band + 1 < bend.bands ? OnwardRay::Way::kBand : OnwardRay::Way::kLastBand;
      through.hue = band_hue(band, bend.bands);
      through.band_part = 1.0f / static_cast<float>(bend.bands);
      const double wavelength = band_wavelength(band, bend.bands);
      through.state.wavelength = wavelength;
      refract(sum, dispersed_ior(bend.ior, bend.dispersion, wavelength), at, through);
    }
    return false;
  }
  OnwardRay& through = add_through();
  bool total_reflection = false;
  if (std::fabs(bend.ior - 1.0) < kTiny && !disperses) {
    ++m_context.counters.refracted_rays;
    through.state.ray.direction = at.ray().direction;
    through.state.straight_on = true;
  } else {
    const double ior =
        disperses ? dispersed_ior(bend.ior, bend.dispersion, at.state.wavelength) : bend.ior;
    total_reflection = refract(sum, ior, at, through);
    if (total_reflection) through.way = OnwardRay::Way::kTotalReflection;  // no layer filters it
  }
  if (is_cut(through.state)) record.onward.pop_back();
  return total_reflection;
}

bool RayStepper::refract(const LayerSum& sum, double ior, const Surface& at, OnwardRay& onward) {
  const std::optional<Vec3> bent = refracted(at.ray().direction, sum.top_normal, ior);
  if (!bent) {
    ++m_context.counters.reflected_rays;
    reflect(sum.top_normal, *sum.top_finish, at, onward);
    return true;
  }
  ++m_context.counters.refracted_rays;
  onward.state.ray.direction = *bent;
  return false;
}

}  // namespace lentray::core
