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
      m_hierarchy(m_scene.hierarchy()), m_layers(context, rules),
      m_shading(context, shadows, rules), m_max_level(m_scene.settings().max_trace_level),
      m_bailout(rules.adc_bailout), m_min_distance(kMinHitDistance * m_scene.tolerance_scale()),
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

namespace {

Surface surface_at(const RayState& state, const Hit& hit, const MetPlace& where,
                   const RayRecord& record) {
  return {state,
          *record.attributes,
          {where.point, where.normal, state.ray.direction, &hit},
          where.normal,
          1.0,
          record.level,
          0,
          where.from_behind};
}

}  // namespace

void RayStepper::see_surface(const RayState& state, const Hit& hit, RayRecord& record) {
  begin_surface(state, hit, record);
  const MetPlace where(state.ray, hit);
  Surface at = surface_at(state, hit, where, record);
  ShadingBuffers& buffers = begin_shading();
  m_shading.begin(at, nullptr, 0, buffers);
  buffers.layers.clear();
  const PlaceLayers found = m_layers.find(state, hit, where, buffers.layers);
  shade(at, found, buffers.layers, buffers, record);
  end_shading();
}

void RayStepper::see_layers(const RayState& state, const Hit& hit, const MetPlace& where,
                            const PlaceLayers& found, const LayerBuffer& layers,
                            const BlockLights& block, std::size_t place, RayRecord& record) {
  begin_surface(state, hit, record);
  Surface at = surface_at(state, hit, where, record);
  ShadingBuffers& buffers = begin_shading();
  m_shading.begin(at, &block, place, buffers);
  shade(at, found, layers, buffers, record);
  end_shading();
}

void RayStepper::shade(Surface& at, const PlaceLayers& found, const LayerBuffer& layers,
                       ShadingBuffers& buffers, RayRecord& record) {
  m_shading.find_lit(found.of(layers), at, buffers);
  each_texture(found, layers, record, [&](Layers texture, double weight) {
    at.texture_weight = weight;
    buffers.begin_texture();
    const Rgb own = sum_up(texture, [&](const Layer& layer, const Rgb& above, Rgb& light) {
      m_shading.light(layer, above, at, buffers, light);
      ++at.layer;
    });
    if (go_on_from(texture)) add_onward(texture, at, record);
    if (!buffers.unscattered.empty()) [[unlikely]]
      add_unscattered(at, buffers, record);
    return own;
  });
}

void RayStepper::go_on(const RayState& state, const Hit& hit, const MetPlace& where, Layers layers,
                       RayRecord& record) {
  add_onward(layers, surface_at(state, hit, where, record), record);
}

[[gnu::always_inline]] inline void RayStepper::add_onward(Layers layers, const Surface& at,
                                                          RayRecord& record) {
  bool total_reflection = false;
  if (m_paths.transparency && layers.back().clear > m_bailout) {
    total_reflection = add_transmitted(layers, at, record);
  }
  if (m_paths.reflection) add_mirrors(layers, total_reflection, at, record);
}

void RayStepper::add_buffers() {
  m_buffers.push_back(std::make_unique<ShadingBuffers>(m_shading.lights()));
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

void RayStepper::add_mirrors(Layers layers, bool total_reflection, const Surface& at,
                             RayRecord& record) {
  double clear = 1.0;  // of the layers above
  for (const Layer& layer : layers) {
    const float weight = static_cast<float>(at.state.weight * clear) * layer.mirror.weight;
    clear = layer.clear;
    if (!m_mirror_images || layer.mirror.colour.is_black()) continue;
    if (total_reflection && nearly_equal(layers.front().normal, layer.normal)) continue;
    ++m_context.counters.reflected_rays;
    if (is_cut(at.level, weight)) continue;
    OnwardRay& image = add_ray(at, weight, record);
    image.way = OnwardRay::Way::kMirror;
    image.share = layer.mirror.colour;
    image.exponent = 1.0 / layer.finish->reflection_exponent;
    reflect(layer, at, image);
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

void RayStepper::reflect(const Layer& layer, const Surface& at, OnwardRay& onward) {
  RayState& state = onward.state;
  state.ray.direction = normalized(mirrored(at.ray().direction, layer.normal, at.normal));
  state.inside = at.state.inside;
  state.tree_place = next_place(2 * at.state.tree_place);
  state.kind = reflected(at.state.kind);
  state.wavelength = at.state.wavelength;
  onward.tinted = layer.finish->irid > 0.0;
  if (onward.tinted) {
    onward.tint = m_shading.film(*layer.finish, layer.normal, state.ray.direction, at);
  }
}

bool RayStepper::add_transmitted(Layers layers, const Surface& at, RayRecord& record) {
  const Layer& top = layers.front();
  const Rgb& filter = layers.back().below;
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
    through.clear = layers.back().clear;
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
      refract(top, dispersed_ior(bend.ior, bend.dispersion, wavelength), at, through);
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
    total_reflection = refract(top, ior, at, through);
    if (total_reflection) through.way = OnwardRay::Way::kTotalReflection;  // no layer filters it
  }
  if (is_cut(through.state)) record.onward.pop_back();
  return total_reflection;
}

bool RayStepper::refract(const Layer& top, double ior, const Surface& at, OnwardRay& onward) {
  const std::optional<Vec3> bent = refracted(at.ray().direction, top.normal, ior);
  if (!bent) {
    ++m_context.counters.reflected_rays;
    reflect(top, at, onward);
    return true;
  }
  ++m_context.counters.refracted_rays;
  onward.state.ray.direction = *bent;
  return false;
}

}  // namespace lentray::core
