#include "core/trace/path_integrator.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/accel/hierarchy.h"
#include "core/base/tiny.h"
#include "core/scene/tolerances.h"
#include "core/trace/indirect_light.h"
#include "core/trace/reflectance.h"
#include "core/trace/segment.h"
#include "core/trace/sky.h"
#include "core/trace/spectrum.h"
#include "core/trace/surface_textures.h"

namespace lentray::core {
namespace {

constexpr double kUnitSlack = 1e-14;  ///< of the squared length of a direction

/// The one at the pixel's centre (random_key.h).
bool is_first_sample(Pixel pixel, std::uint64_t key) {
  return key == std::bit_cast<std::uint64_t>(pixel);
}

bool nearly_equal(const Vec3& a, const Vec3& b) {
  return std::fabs(a.x - b.x) <= kTiny && std::fabs(a.y - b.y) <= kTiny &&
         std::fabs(a.z - b.z) <= kTiny;
}

}  // namespace

template <unsigned kFeatures>
PathIntegrator<kFeatures>::PathIntegrator(ThreadContext& context, ShadowTester& shadows,
                                          const PathRules& rules)
    : m_context(context), m_scene(context.scene), m_hierarchy(m_scene.hierarchy()),
      m_shading(context, shadows, rules), m_max_level(m_scene.settings().max_trace_level),
      m_bailout(rules.adc_bailout), m_min_distance(kMinHitDistance * m_scene.tolerance_scale()),
      m_atmosphere_ior(m_scene.settings().atmosphere_ior),
      m_mirror_images(m_scene.settings().mirror_images),
      m_air(m_scene.needs().atmosphere && rules.volumes ? &m_scene.atmosphere() : nullptr) {
  if (m_scene.needs().media && rules.volumes)
    m_media = std::make_unique<MediaLight>(context, shadows);
  if (m_scene.needs().interiors) m_start_interiors = std::make_unique<StartInteriors>(m_scene);
}

template <unsigned kFeatures>
Radiance PathIntegrator<kFeatures>::trace(const Ray& ray, Pixel pixel, std::uint64_t key) {
  Ray unit;
  const bool is_unit = !(std::fabs(length_squared(ray.direction) - 1.0) > kUnitSlack);
  if (!is_unit) unit = {ray.origin, normalized(ray.direction)};
  m_context.pixel = pixel;
  m_context.random.begin(key);
  if (m_context.indirect) m_context.indirect->begin(pixel, is_first_sample(pixel, key), key);
  ++m_context.counters.camera_rays;
  RayState state(is_unit ? ray : unit);
  if (m_start_interiors) state.inside = m_start_interiors->at(ray.origin);
  return follow(state, 1.0f, 0);
}

template <unsigned kFeatures>
Radiance PathIntegrator<kFeatures>::follow(const RayState& state, float weight, int level,
                                           bool straight_on) {
  if (level >= m_max_level || weight < m_bailout) return {};
  if (m_depth >= m_deepest) {
    ++m_context.counters.cut_rays;
    return {};
  }
  Hit hit;
  const bool met = m_hierarchy.nearest(state.ray, m_min_distance, Bounds::kInf, state.kind, hit,
                                       m_context.arena, m_context.tests);
  return seen_at(state, met ? &hit : nullptr, weight, level, straight_on);
}

template <unsigned kFeatures>
GatheredRay PathIntegrator<kFeatures>::gather(const GatherRay& from) {
  GatheredRay seen;
  if (m_depth >= m_deepest) {
    ++m_context.counters.cut_rays;
    return seen;
  }
  RayState state(from.ray);
  state.kind = RayKind::kGather;
  Hit hit;
  const bool met = m_hierarchy.nearest(state.ray, m_min_distance, Bounds::kInf, state.kind, hit,
                                       m_context.arena, m_context.tests);
  seen.importance = static_cast<float>(met ? m_scene.pass_flags(hit.leaf->attributes()).importance
                                           : m_scene.settings().radiosity->default_importance);
  if (met) seen.distance = hit.t;
  if (seen.importance < from.least_importance) return seen;
  const SampleRandom random = m_context.random;
  m_context.random.begin(from.key);
  // However deep the gathers are, each sees as far as its own ray.
  const int most = std::exchange(m_max_level, std::max(m_max_level, from.level + 1));
  seen.light = seen_at(state, met ? &hit : nullptr, from.weight, from.level, false).rgb;
  m_max_level = most;
  m_context.random = random;
  return seen;
}

template <unsigned kFeatures>
Radiance PathIntegrator<kFeatures>::seen_at(const RayState& state, const Hit* hit, float weight,
                                            int level, bool straight_on) {
  if (!hit) {
    Radiance sky = sky_radiance(m_scene, state.ray.direction, state.kind >= RayKind::kReflection);
    if (m_air) pass_open_air(state, kOpenAir, level + 1, nullptr, sky);
    return sky;
  }
  if (!straight_on) ++level;
  Radiance seen = shade(state, *hit, weight, level);
  const Attributes& looks = hit->leaf->attributes();
  if (m_media) m_media->pass_interiors(state, hit->t, level, looks, seen);
  if (m_air) pass_open_air(state, hit->t, level, &looks, seen);
  return seen;
}

template <unsigned kFeatures>
void PathIntegrator<kFeatures>::pass_open_air(const RayState& state, double length, int level,
                                              const Attributes* looks, Radiance& light) {
  if (!state.inside.is_hollow()) return;
  const Segment segment{state.ray, length};
  if (!m_air->rainbows.empty()) pass_rainbows(*m_air, segment, m_context.random, light);
  if (!m_air->media.empty()) m_media->pass_air(state, length, level, looks, light);
  if (!m_air->fogs.empty()) pass_fogs(*m_air, segment, light);
}

template <unsigned kFeatures>
ShadingBuffers& PathIntegrator<kFeatures>::enter_surface() {
  if (m_depth == m_buffers.size()) {
    m_buffers.push_back(std::make_unique<ShadingBuffers>(m_shading.lights()));
    // Clear surfaces do not count as levels, so that there may be any number of them. Half of the
    // stack is for steps that take more of it than these.
    const auto here = reinterpret_cast<std::uintptr_t>(__builtin_frame_address(0));
    if (here < m_stack_end) m_deepest = m_depth + 1;
  }
  return *m_buffers[m_depth++];
}

template <unsigned kFeatures>
Radiance PathIntegrator<kFeatures>::shade(const RayState& state, const Hit& hit, float weight,
                                          int level) {
  const Vec3 point = state.ray.at(hit.t);
  Vec3 normal = hit.leaf->normal(point, hit.shape);
  const bool from_behind = dot(normal, state.ray.direction) > 0.0;
  if (from_behind) normal = -normal;
  Surface at{state,
             hit.leaf->attributes(),
             {point, normal, state.ray.direction, &hit},
             normal,
             point,
             1.0,
             weight,
             level,
             from_behind};
  if (at.looks.uv_mapping) at.texture_point = texture_point(at.context);
  ShadingBuffers& buffers = enter_surface();
  m_shading.begin(at, buffers);
  Radiance seen;
  if constexpr (kLayers) {
    seen = shade_textures(at, buffers);
  } else {
    seen = shade_texture(*at.looks.texture->everywhere(), at, buffers);
  }
  --m_depth;
  return seen;
}

template <unsigned kFeatures>
Radiance PathIntegrator<kFeatures>::shade_textures(Surface& at, ShadingBuffers& buffers) {
  textures_at(at.context, at.from_behind, m_bailout, buffers.textures);
  if (buffers.textures.size() == 1 && buffers.textures.front().weight == 1.0) {
    return shade_texture(*buffers.textures.front().texture, at, buffers);
  }
  Radiance sum;
  for (const WeightedTexture& part : buffers.textures) {
    at.context.normal = at.normal;
    at.texture_weight = part.weight;
    const Radiance seen = shade_texture(*part.texture, at, buffers);
    sum.rgb += times(seen.rgb, part.weight);
    sum.transmit += static_cast<float>(seen.transmit * part.weight);
  }
  return sum;
}

template <unsigned kFeatures>
Radiance PathIntegrator<kFeatures>::shade_texture(const LayeredTexture& texture, Surface& at,
                                                  ShadingBuffers& buffers) {
  LayerSum sum;
  m_shading.shade(texture, at, buffers, sum);
  Radiance result;
  result.rgb = sum.light;
  bool total_reflection = false;
  if (kTransparency && sum.transparency > m_bailout) {
    total_reflection = add_transmitted(sum, at, result);
  }
  if constexpr (kReflection) add_mirror_images(sum, total_reflection, at, buffers, result);
  return result;
}

template <unsigned kFeatures>
void PathIntegrator<kFeatures>::add_mirror_images(const LayerSum& sum, bool total_reflection,
                                                  const Surface& at, ShadingBuffers& buffers,
                                                  Radiance& result) {
  for (std::size_t i = 0; m_mirror_images && i < sum.layers; ++i) {
    const Mirror& mirror = buffers.mirrors[i];
    if (mirror.colour.is_black()) continue;
    if (total_reflection && nearly_equal(sum.top_normal, mirror.normal)) continue;
    Rgb image = mirror_image(mirror.normal, mirror.weight, at, *mirror.finish);
    if (mirror.exponent != 1.0) {
      for (int c = 0; c < 3; ++c) {
        image[c] = static_cast<float>(std::pow(image[c], mirror.exponent));
      }
    }
    result.rgb += mirror.colour * image;
  }
}

template <unsigned kFeatures>
Rgb PathIntegrator<kFeatures>::mirror_image(const Vec3& normal, float weight, const Surface& at,
                                            const Finish& film) {
  const Vec3& incoming = at.ray().direction;
  ++m_context.counters.reflected_rays;
  const Ray ray{at.point(), normalized(mirrored(incoming, normal, at.normal))};
  RayState next(ray, at.state.inside, 2 * at.state.place, reflected(at.state.kind));
  next.wavelength = at.state.wavelength;
  Rgb seen = follow(next, weight, at.level).rgb;
  if (film.irid > 0.0) seen *= m_shading.film(film, normal, ray.direction, at);
  return seen;
}

template <unsigned kFeatures>
bool PathIntegrator<kFeatures>::add_transmitted(const LayerSum& sum, const Surface& at,
                                                Radiance& result) {
  const Rgb& filter = sum.filter;
  const float most = greatest({std::fabs(filter.r), std::fabs(filter.g), std::fabs(filter.b)});
  Onward onward(at, at.weight * most);
  const InteriorEntry interior = at.interior();
  const Bend bend =
      m_start_interiors ? enter(interior, m_atmosphere_ior, onward.state.inside) : Bend();

  Rgb fade(1.0f);
  if (interior.interior) {
    fade = Rgb(interior.interior->passed);
    if (at.state.inside.contains(interior.key)) {
      fade *= fade_in_interior(*interior.interior, at.context.hit->t);
    }
  }
  Radiance seen;
  const bool disperses = !(std::fabs(bend.dispersion - 1.0) < kTiny);
  if (std::fabs(bend.ior - 1.0) < kTiny && !disperses) {
    ++m_context.counters.refracted_rays;
    seen = follow(onward.state, onward.weight, at.level, true);
  } else if (disperses && at.state.wavelength == RayState::kWhite) {
    seen.rgb = disperse(sum, at, bend, onward);
  } else {
    const double ior =
        disperses ? dispersed_ior(bend.ior, bend.dispersion, at.state.wavelength) : bend.ior;
    if (refract(sum, at, ior, onward, seen)) {
      // The layers do not filter it.
      result.rgb += fade * seen.rgb;
      return true;
    }
  }
  result.rgb += fade * seen.rgb * filter;
  result.transmit = static_cast<float>(grey(fade) * seen.transmit * sum.transparency);
  return false;
}

template <unsigned kFeatures>
bool PathIntegrator<kFeatures>::refract(const LayerSum& sum, const Surface& at, double ior,
                                        Onward& onward, Radiance& seen) {
  const Vec3& incoming = at.ray().direction;
  double cosine = dot(incoming, sum.top_normal);
  const Vec3 normal = cosine <= 0.0 ? sum.top_normal : -sum.top_normal;
  cosine = std::fabs(cosine);
  const double under_root = 1.0 + ior * ior * (cosine * cosine - 1.0);
  if (under_root < 0.0) {
    seen.rgb = mirror_image(sum.top_normal, onward.weight, at, *sum.top_finish);
    return true;
  }
  onward.ray.direction = incoming * ior + normal * (ior * cosine - std::sqrt(under_root));
  ++m_context.counters.refracted_rays;
  seen = follow(onward.state, onward.weight, at.level);
  return false;
}

template <unsigned kFeatures>
Rgb PathIntegrator<kFeatures>::disperse(const LayerSum& sum, const Surface& at, const Bend& bend,
                                        Onward& onward) {
  Rgb all;
  for (int band = 0; band < bend.bands; ++band) {
    onward.state.wavelength = band_wavelength(band, bend.bands);
    Radiance seen;
    refract(sum, at, dispersed_ior(bend.ior, bend.dispersion, onward.state.wavelength), onward,
            seen);
    all += seen.rgb * band_hue(band, bend.bands);
  }
  return all * (1.0f / static_cast<float>(bend.bands));
}

unsigned path_features(const Needs& needs) {
  unsigned features = 0;
  if (needs.transparency || needs.refraction) features |= kPathTransparency;
  if (needs.reflection) features |= kPathReflection;
  if (needs.layered_textures || needs.textures_by_place || needs.interior_textures) {
    features |= kPathLayers;
  }
  if (needs.area_lights) features |= kPathArea;
  return features;
}

namespace {

using Maker = std::unique_ptr<Integrator> (*)(ThreadContext&, ShadowTester&, const PathRules&);

template <unsigned kFeatures>
std::unique_ptr<Integrator> make_one(ThreadContext& context, ShadowTester& shadows,
                                     const PathRules& rules) {
  return std::make_unique<PathIntegrator<kFeatures>>(context, shadows, rules);
}

template <unsigned... kFeatures>
constexpr std::array<Maker, sizeof...(kFeatures)> all_makers(
    std::integer_sequence<unsigned, kFeatures...>) {
  return {make_one<kFeatures>...};
}

}  // namespace

std::unique_ptr<Integrator> make_path_integrator(unsigned features, ThreadContext& context,
                                                 ShadowTester& shadows, const PathRules& rules) {
  static constexpr auto kMakers = all_makers(std::make_integer_sequence<unsigned, kAllPaths>{});
  return kMakers.at(features)(context, shadows, rules);
}

std::unique_ptr<Integrator> Integrator::make(ThreadContext& context, ShadowTester& shadows) {
  return make(context, shadows, PathRules{context.scene.settings().adc_bailout});
}

std::unique_ptr<Integrator> Integrator::make(ThreadContext& context, ShadowTester& shadows,
                                             const PathRules& rules) {
  unsigned features = path_features(context.scene.needs());
  if (!rules.area_lights) features &= ~static_cast<unsigned>(kPathArea);
  return make_path_integrator(features, context, shadows, rules);
}

}  // namespace lentray::core
