// The tracer's paths. Order of the steps within a surface, the weights and where adc_bailout
// and max_trace_level cut are stock's (tests/image/shading_depth_test.cpp).
#include "core/render/tracer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/noise/noise.h"
#include "core/object/leaf.h"
#include "core/render/air.h"
#include "core/render/path_tracer.h"

namespace lentray::core {
namespace {

constexpr double kTiny = 1e-10;
constexpr double kUnitSlack = 1e-14;  ///< of the squared length of a direction

bool nearly_equal(const Vec3& a, const Vec3& b) {
  return std::fabs(a.x - b.x) <= kTiny && std::fabs(a.y - b.y) <= kTiny &&
         std::fabs(a.z - b.z) <= kTiny;
}

bool reflects(const Finish& finish) {
  return !finish.reflection_max.is_black() || !finish.reflection_min.is_black();
}

float opacity_of(const Colour& c, bool legacy) {
  // Scenes before 3.7 weigh the filter by the brightest channel.
  if (legacy) return 1.0f - (c.filter * greatest(c.rgb) + c.transmit);
  return 1.0f - c.filter - c.transmit;
}

}  // namespace

template <unsigned kFeatures>
Radiance PathTracer<kFeatures>::trace(const Ray& ray, Pixel pixel, std::uint64_t key) {
  Ray unit;
  const bool is_unit = !(std::fabs(length_squared(ray.direction) - 1.0) > kUnitSlack);
  if (!is_unit) unit = {ray.origin, normalized(ray.direction)};
  m_pixel = pixel;
  m_key = key;
  m_random.reset();
  ++m_counters.camera_rays;
  RayState state(is_unit ? ray : unit);
  if (m_start_interiors) state.inside = m_start_interiors->at(ray.origin);
  return follow(state, 1.0f, 0);
}

template <unsigned kFeatures>
Radiance PathTracer<kFeatures>::follow(const RayState& state, float weight, int level,
                                       bool straight_on) {
  if (level >= m_max_level || weight < m_bailout) return {};
  if (m_depth >= m_deepest) {
    ++m_counters.cut_rays;
    return {};
  }
  Hit hit;
  if (!m_hierarchy.nearest(state.ray, m_min_distance, Bounds::kInf, state.kind, hit, m_arena,
                           m_test_counters)) {
    Radiance sky = sky_radiance(m_scene, state.ray.direction, state.kind == RayKind::kReflection);
    if (m_air) pass_open_air(state, kOpenAir, sky);
    return sky;
  }
  Radiance seen = shade(state, hit, weight, straight_on ? level : level + 1);
  if (m_air) pass_open_air(state, hit.t, seen);
  return seen;
}

template <unsigned kFeatures>
void PathTracer<kFeatures>::pass_open_air(const RayState& state, double depth, Radiance& light) {
  if (!state.inside.is_hollow()) return;
  pass_air(*m_air, state.ray, depth, [this] { return random(); }, light);
}

template <unsigned kFeatures>
typename PathTracer<kFeatures>::Frame& PathTracer<kFeatures>::enter_frame() {
  if (m_depth == m_frames.size()) {
    m_frames.push_back(std::make_unique<Frame>(m_scene.lights().size()));
    // Clear surfaces do not count as levels, so that there may be any number of them. Half of the
    // stack is for steps that take more of it than these.
    const auto here = reinterpret_cast<std::uintptr_t>(__builtin_frame_address(0));
    if (here < m_stack_end) m_deepest = m_depth + 1;
  }
  Frame& frame = *m_frames[m_depth++];
  if constexpr (kLayers) {
    frame.textures.clear();
    std::fill(frame.light_known.begin(), frame.light_known.end(), std::uint8_t{0});
  }
  return frame;
}

/// Finds the point in the lights' buffers before anything else is done with it, so that their
/// cells are there when the light loop comes to them. Lights behind the surface are most often
/// not asked for.
template <unsigned kFeatures>
void PathTracer<kFeatures>::look_ahead(const Surface& at, Frame& frame) const {
  for (const std::span<const std::uint32_t> lights : lights_of(at.looks)) {
    for (const std::uint32_t i : lights) {
      const Source& source = m_sources[i];
      LightBuffer::Spot& spot = frame.spots[i];
      spot.known =
          source.buffer && !source.surely_behind(source.position - at.point(), at.normal);
      spot.unmet = nullptr;
      if (spot.known) source.buffer->locate(at.point(), spot);
    }
  }
  // A test of what is simpler costs no more.
  constexpr double kWorthwhile = 12.0;
  const Hit& hit = *at.context.hit;
  if (hit.object->test_cost() >= kWorthwhile && hit.leaf->convexity() != Convexity::kNone) find_unmet(at, frame);
}

/// Where all of the object lies behind the plane of its surface, but for rounding, rays to the lights before it
/// do not meet it. Rounding can have the point so far within that one with less than `slope` for the cosine is
/// not out before the tolerance.
template <unsigned kFeatures>
[[gnu::noinline]] void PathTracer<kFeatures>::find_unmet(const Surface& at, Frame& frame) const {
  constexpr double kLeast = 1e-3, kRounding = 1e-9;
  const Hit& hit = *at.context.hit;
  if (!hit.object->lies_in_parts()) return;
  const bool either_side = hit.leaf->convexity() == Convexity::kFlat && hit.object == hit.leaf;
  if (at.from_behind && !either_side) return;
  const Vec3& p = at.point();
  const double off = kRounding * (std::fabs(p.x) + std::fabs(p.y) + std::fabs(p.z) + hit.t);
  const double slope = std::max(kLeast, off / m_shadow_tolerance);
  for (const std::span<const std::uint32_t> lights : lights_of(at.looks)) {
    for (const std::uint32_t i : lights) {
      if (!frame.spots[i].known || !m_sources[i].straight) continue;
      const Vec3 to = m_sources[i].position - p;
      const double up = dot(at.normal, to);
      if (up > 0.0 && up * up > slope * slope * length_squared(to)) frame.spots[i].unmet = hit.object;
    }
  }
}

template <unsigned kFeatures>
Radiance PathTracer<kFeatures>::shade(const RayState& state, const Hit& hit, float weight,
                                      int level) {
  const Vec3 point = state.ray.at(hit.t);
  Vec3 normal = hit.leaf->normal(point, hit.shape);
  const bool from_behind = dot(normal, state.ray.direction) > 0.0;
  if (from_behind) normal = -normal;
  Surface at{state, hit.leaf->attributes(), {point, normal, state.ray.direction, &hit},
             normal, point, weight, level, from_behind};
  if (at.looks.uv_mapping) at.texture_point = texture_point(at.context);
  Frame& frame = enter_frame();
  look_ahead(at, frame);
  Radiance seen;
  if constexpr (kLayers) {
    seen = shade_textures(at, frame);
  } else {
    seen = shade_texture(*at.looks.texture->everywhere(), at, frame);
  }
  --m_depth;
  return seen;
}

template <unsigned kFeatures>
Radiance PathTracer<kFeatures>::shade_textures(Surface& at, Frame& frame) {
  textures_at(at.context, at.from_behind, m_bailout, frame.textures);
  if (frame.textures.size() == 1 && frame.textures.front().weight == 1.0) {
    return shade_texture(*frame.textures.front().texture, at, frame);
  }
  Radiance sum;
  for (const WeightedTexture& part : frame.textures) {
    at.context.normal = at.normal;
    const Radiance seen = shade_texture(*part.texture, at, frame);
    sum.rgb += times(seen.rgb, part.weight);
    sum.transmit += static_cast<float>(seen.transmit * part.weight);
  }
  return sum;
}

template <unsigned kFeatures>
Radiance PathTracer<kFeatures>::shade_texture(const LayeredTexture& texture, Surface& at,
                                              Frame& frame) {
  const auto& layers = texture.layers();
  Stack stack;
  if constexpr (kReflection) {
    if (frame.mirrors.size() < layers.size()) frame.mirrors.resize(layers.size());
  }
  for (auto layer = layers.rbegin();
       layer != layers.rend() && stack.transparency > m_bailout; ++layer) {
    shade_layer(*layer, at, stack, frame);
    ++stack.layers;
  }
  Radiance result;
  result.rgb = stack.sum;
  bool total_reflection = false;
  if (kTransparency && stack.transparency > m_bailout) {
    total_reflection = add_transmitted(stack, at, result);
  }
  if constexpr (kReflection) add_mirror_images(stack, total_reflection, at, frame, result);
  return result;
}

template <unsigned kFeatures>
void PathTracer<kFeatures>::shade_layer(const TextureLayer& layer, Surface& at, Stack& stack,
                                        Frame& frame) {
  const Finish& finish = layer.finish;
  const Colour* constant = layer.pigment->constant();
  const Colour colour = constant ? *constant : layer.pigment->colour(at.texture_point, at.context);
  if (layer.normal) {
    at.context.normal = layer.normal->perturb(at.texture_point, at.normal, at.context);
  }
  const Vec3& normal = layer.normal ? at.context.normal : at.normal;
  if (kTransparency && stack.layers == 0) {
    stack.top_normal = normal;
    stack.top_finish = &finish;
  }
  if constexpr (kReflection) {
    frame.mirrors[stack.layers] = mirror_of(finish, colour.rgb, normal, at, stack);
  }

  const double opacity = kTransparency || kLayers ? opacity_of(colour, m_legacy_opacity) : 1.0;
  Rgb own = times(colour.rgb * finish.ambient * m_scene.settings().ambient_light, opacity);
  own += times(colour.rgb * finish.emission, opacity);
  own += lit(finish, colour.rgb, normal, opacity, at, frame);
  stack.sum += own * stack.filter;

  if constexpr (kTransparency || kLayers) {
    stack.filter *= passed(colour);
    if (kReflection && finish.conserve_energy) {
      const Rgb& mirror = frame.mirrors[stack.layers].colour;
      stack.filter *= Rgb(std::min(1.0f, 1.0f - mirror.r), std::min(1.0f, 1.0f - mirror.g),
                          std::min(1.0f, 1.0f - mirror.b));
    }
    stack.transparency = std::min(1.0, static_cast<double>(std::fabs(grey(stack.filter))));
  } else {
    stack.transparency = 0.0;
  }
}

template <unsigned kFeatures>
typename PathTracer<kFeatures>::Mirror PathTracer<kFeatures>::mirror_of(
    const Finish& finish, const Rgb& pigment, const Vec3& normal, const Surface& at,
    const Stack& stack) const {
  Mirror mirror;
  if (!reflects(finish)) return mirror;
  const double cosine = -dot(at.ray().direction, normal);
  const double ior =
      finish.reflection_fresnel ? relative_ior(at.interior(), at.state.inside) : 1.0;
  const Reflectivity share = reflectivity(finish, cosine, ior, pigment);
  mirror.normal = normal;
  mirror.colour = share.colour;
  mirror.weight = static_cast<float>(at.weight * stack.transparency) * share.weight;
  mirror.exponent = 1.0 / finish.reflection_exponent;
  mirror.finish = &finish;
  return mirror;
}

template <unsigned kFeatures>
void PathTracer<kFeatures>::add_mirror_images(const Stack& stack, bool total_reflection,
                                              const Surface& at, Frame& frame,
                                              Radiance& result) {
  for (std::size_t i = 0; m_mirror_images && i < stack.layers; ++i) {
    const Mirror& mirror = frame.mirrors[i];
    if (mirror.colour.is_black()) continue;
    if (total_reflection && nearly_equal(stack.top_normal, mirror.normal)) continue;
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
Rgb PathTracer<kFeatures>::lit(const Finish& finish, const Rgb& pigment, const Vec3& normal,
                               double opacity, const Surface& at, Frame& frame) {
  Rgb sum;
  if (finish.diffuse == 0.0 && finish.diffuse_back == 0.0 && finish.specular == 0.0 &&
      finish.phong == 0.0) {
    return sum;
  }
  const bool one_sided = !at.looks.double_illuminate;
  const bool front_only = one_sided && finish.diffuse_back == 0.0;
  const bool shines = has_highlights(finish);
  ShadowQuery query = query_from(at);
  for (const std::span<const std::uint32_t> lights : lights_of(at.looks)) {
    for (const std::uint32_t i : lights) {
      const Source& source = m_sources[i];
      const Vec3 to = source.position - at.point();
      if (front_only && source.surely_behind(to, normal)) continue;
      const LightRay ray = source.straight ? ray_along(to) : light_ray(source.light, at.point());
      Rgb colour = source.even ? source.colour : light_colour(source.light, at.point(), ray);
      if (is_dark(colour)) continue;
      const double cosine = dot(normal, ray.direction);
      const bool behind = one_sided && cosine < kTiny;
      if (behind && front_only) continue;
      if (!source.shadowless) {
        colour = arriving(i, colour, ray, query, frame);
        if (is_dark(colour)) continue;
      }
      Rgb share = diffuse_light(finish, cosine, colour, pigment,
                                behind ? finish.diffuse_back : finish.diffuse, opacity,
                                finish.crand > 0.0 ? random() : 0.0);
      if (shines && !source.shadowless && !behind) {
        share += highlights(finish, {ray.direction, at.ray().direction, normal, colour, pigment});
      }
      if (finish.irid > 0.0) {
        share *= film_tint(finish, film_thickness(finish, at.point()),
                           m_scene.settings().irid_wavelength, normal, ray.direction,
                           at.ray().direction);
      }
      sum += share;
    }
  }
  return sum;
}

template <unsigned kFeatures>
ShadowQuery PathTracer<kFeatures>::query_from(const Surface& at) const {
  ShadowQuery query;
  query.ray.origin = at.point();
  query.depth = at.level;
  query.tree_place = at.state.place;
  query.column = m_pixel.column;
  query.row = m_pixel.row;
  query.inside = &at.state.inside;
  return query;
}

template <unsigned kFeatures>
Rgb PathTracer<kFeatures>::arriving(std::uint32_t light, const Rgb& colour, const LightRay& ray,
                                    ShadowQuery& query, Frame& frame) {
  if constexpr (kLayers) {
    if (frame.light_known[light]) return frame.light[light];
  }
  query.light = light;
  Rgb result;
  if constexpr (kArea) {
    result = m_scene.lights()[light].has_area ? area_shadowed(colour, ray, query)
                                              : shadowed(colour, ray, query, frame);
  } else {
    result = shadowed(colour, ray, query, frame);
  }
  if constexpr (kLayers) {
    frame.light[light] = result;
    frame.light_known[light] = 1;
  }
  return result;
}

template <unsigned kFeatures>
Rgb PathTracer<kFeatures>::shadowed(const Rgb& colour, const LightRay& ray, ShadowQuery& query,
                                    const Frame& frame) {
  const LightBuffer::Spot& spot = frame.spots[query.light];
  query.spot = spot.known ? &spot : nullptr;
  query.sample = 0;
  query.ray.direction = ray.direction;
  query.distance = ray.distance;
  return colour * m_shadows.visibility(query).filter;
}

template <unsigned kFeatures>
Rgb PathTracer<kFeatures>::area_shadowed(const Rgb& colour, const LightRay& ray,
                                         ShadowQuery& query) {
  const Light& source = m_scene.lights()[query.light];
  query.spot = nullptr;
  auto probe = [&](const Vec3& offset, std::uint32_t sample) {
    const LightRay to_sample = light_ray(source, query.ray.origin, offset);
    query.ray.direction = to_sample.direction;
    query.distance = to_sample.distance;
    query.sample = sample;
    return colour * m_shadows.visibility(query).filter;
  };
  auto random_number = [this] { return random(); };
  const AreaAxes axes = area_axes(source.area, ray.direction);
  return AreaSampler(source.area, axes, m_area, probe, random_number).colour();
}

template <unsigned kFeatures>
Rgb PathTracer<kFeatures>::mirror_image(const Vec3& normal, float weight, const Surface& at,
                                        const Finish& film) {
  const Vec3& incoming = at.ray().direction;
  Vec3 out = incoming + normal * (-2.0 * dot(incoming, normal));
  // A perturbed normal may send the ray through the real surface: mirror it back.
  const double through = dot(out, at.normal);
  if (through < 0.0) {
    if (dot(out, normal) < 0.0) {
      out = incoming + at.normal * (-2.0 * dot(incoming, at.normal));
    } else {
      out += at.normal * (-2.0 * through);
    }
  }
  ++m_counters.reflected_rays;
  const Ray ray{at.point(), normalized(out)};
  const RayState next(ray, at.state.inside, 2 * at.state.place, RayKind::kReflection);
  Rgb seen = follow(next, weight, at.level).rgb;
  if (film.irid > 0.0) {
    seen *= film_tint(film, film_thickness(film, at.point()), m_scene.settings().irid_wavelength,
                      normal, ray.direction, incoming);
  }
  return seen;
}

template <unsigned kFeatures>
double PathTracer<kFeatures>::film_thickness(const Finish& finish, const Vec3& point) const {
  if (finish.irid_turbulence == 0.0) return finish.irid_thickness;
  const Turbulence uneven{{1, 1, 1}, 5, 2.0, 0.5};
  const double noise = 2.0 * turbulence(point, uneven, m_scene.settings().noise_generator) - 1.0;
  return finish.irid_thickness * (1.0 + noise * finish.irid_turbulence);
}

template <unsigned kFeatures>
bool PathTracer<kFeatures>::add_transmitted(const Stack& stack, const Surface& at,
                                            Radiance& result) {
  const Rgb& filter = stack.filter;
  const float most = greatest({std::fabs(filter.r), std::fabs(filter.g), std::fabs(filter.b)});
  const float weight = at.weight * most;
  Ray onward{at.point(), at.ray().direction};
  RayState next(onward, at.state.inside, 2 * at.state.place + 1,
                std::max(at.state.kind, RayKind::kTransmitted));
  const InteriorEntry interior = at.interior();
  const double ratio = m_start_interiors ? enter(interior, next.inside) : 1.0;

  Rgb fade(1.0f);
  if (interior.interior && at.state.inside.contains(interior.key)) {
    fade = fade_in_interior(*interior.interior, at.context.hit->t);
  }
  Radiance seen;
  if (std::fabs(ratio - 1.0) < kTiny) {
    ++m_counters.refracted_rays;
    seen = follow(next, weight, at.level, true);
  } else {
    double cosine = dot(onward.direction, stack.top_normal);
    const Vec3 normal = cosine <= 0.0 ? stack.top_normal : -stack.top_normal;
    cosine = std::fabs(cosine);
    const double under_root = 1.0 + ratio * ratio * (cosine * cosine - 1.0);
    if (under_root < 0.0) {
      // Total internal reflection: the layers do not filter it.
      result.rgb += fade * mirror_image(stack.top_normal, weight, at, *stack.top_finish);
      return true;
    }
    onward.direction =
        onward.direction * ratio + normal * (ratio * cosine - std::sqrt(under_root));
    ++m_counters.refracted_rays;
    seen = follow(next, weight, at.level);
  }
  result.rgb += fade * seen.rgb * filter;
  result.transmit = static_cast<float>(grey(fade) * seen.transmit * stack.transparency);
  return false;
}

// Changes the stack as the ray passes the surface; returns the ior before over the ior behind.
// Nested objects count as cut out of those around them; where objects overlap, the one that was
// entered last fills the overlap, and leaving the other one there bends nothing.
template <unsigned kFeatures>
double PathTracer<kFeatures>::enter(const InteriorEntry& entry, InteriorStack& inside) const {
  const double ior = entry.ior(m_atmosphere_ior);
  if (inside.empty()) {
    inside.push(entry);
    return m_atmosphere_ior / ior;
  }
  if (inside.back().key == entry.key) {
    inside.remove(entry.key);
    return ior / (inside.empty() ? m_atmosphere_ior : inside.back().ior(m_atmosphere_ior));
  }
  if (inside.remove(entry.key)) return 1.0;
  const double before = inside.back().ior(m_atmosphere_ior);
  inside.push(entry);
  return before / ior;
}

// For the Fresnel term: behind over before. Leaving a nested object compares with the innermost
// interior, which is most often the object itself: stock's way, kept.
template <unsigned kFeatures>
double PathTracer<kFeatures>::relative_ior(const InteriorEntry& entry,
                                           const InteriorStack& inside) const {
  const double ior = entry.ior(m_atmosphere_ior);
  if (inside.empty()) return ior / m_atmosphere_ior;
  const double innermost = inside.back().ior(m_atmosphere_ior);
  if (!inside.contains(entry.key)) return ior / innermost;
  return (inside.size() == 1 ? m_atmosphere_ior : innermost) / ior;
}

template <unsigned kFeatures>
double PathTracer<kFeatures>::random() {
  if (!m_random) m_random.emplace(m_key, RandomSequence::Use::kShading);
  return m_random->next();
}

namespace {

using Maker = std::unique_ptr<Tracer> (*)(const Scene&, ShadowTester&, HitArena&, Counters&, bool);

template <unsigned kFeatures>
std::unique_ptr<Tracer> make_one(const Scene& scene, ShadowTester& shadows, HitArena& arena,
                                 Counters& counters, bool count_tests) {
  return std::make_unique<PathTracer<kFeatures>>(scene, shadows, arena, counters, count_tests);
}

template <unsigned... kFeatures>
constexpr std::array<Maker, sizeof...(kFeatures)> all_makers(
    std::integer_sequence<unsigned, kFeatures...>) {
  return {make_one<kFeatures>...};
}

}  // namespace

std::unique_ptr<Tracer> make_path_tracer(unsigned features, const Scene& scene,
                                         ShadowTester& shadows, HitArena& arena,
                                         Counters& counters, bool count_tests) {
  static constexpr auto kMakers = all_makers(std::make_integer_sequence<unsigned, kAllPaths>{});
  return kMakers.at(features)(scene, shadows, arena, counters, count_tests);
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

std::unique_ptr<Tracer> Tracer::make(const Scene& scene, ShadowTester& shadows, HitArena& arena,
                                     Counters& counters, bool count_tests) {
  return make_path_tracer(path_features(scene.needs()), scene, shadows, arena, counters,
                          count_tests);
}

}  // namespace lentray::core
