// The tracer's paths. Order of the steps within a surface, the weights and where adc_bailout
// and max_trace_level cut are stock's (tests/image/shading_depth_test.cpp).
#include "core/render/tracer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/render/air.h"
#include "core/pattern/noise.h"
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

std::uint64_t mixed(std::uint64_t x) {  // splitmix64
  x += 0x9e3779b97f4a7c15ull;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
  return x ^ (x >> 31);
}

float opacity_of(const Colour& c, bool legacy) {
  // Scenes before 3.7 weigh the filter by the brightest channel.
  if (legacy) return 1.0f - (c.filter * greatest(c.rgb) + c.transmit);
  return 1.0f - c.filter - c.transmit;
}

}  // namespace

template <unsigned kFeatures>
Radiance PathTracer<kFeatures>::trace(const Ray& ray, Pixel pixel) {
  m_pixel = pixel;
  m_random_state =
      mixed((static_cast<std::uint64_t>(pixel.row) << 32 | pixel.column) ^ 0x6c656e74726179ull);
  ++m_counters.camera_rays;
  RayState state;
  state.ray = ray;
  if (std::fabs(length_squared(ray.direction) - 1.0) > kUnitSlack) {
    state.ray.direction = normalized(ray.direction);
  }
  if (m_start_interiors) state.inside = m_start_interiors->at(ray.origin);
  return follow(state, 1.0f, 0);
}

template <unsigned kFeatures>
Radiance PathTracer<kFeatures>::follow(const RayState& state, float weight, int level,
                                       bool straight_on) {
  if (level >= m_max_level || weight < m_bailout) return {};
  Hit hit;
  const RayKind kind = state.reflected ? RayKind::kReflection : RayKind::kCamera;
  if (!m_hierarchy.nearest(state.ray, kMinHitDistance, Bounds::kInf, kind, hit, m_arena,
                           m_test_counters)) {
    Radiance sky = sky_radiance(m_scene, state.ray.direction);
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
  if (m_depth == m_frames.size()) m_frames.push_back(std::make_unique<Frame>());
  Frame& frame = *m_frames[m_depth++];
  frame.textures.clear();
  if constexpr (kLayers) {
    frame.light.resize(m_scene.lights().size());
    frame.light_known.assign(m_scene.lights().size(), 0);
  }
  return frame;
}

/// Finds the point in the lights' buffers before anything else is done with it, so that their
/// cells are there when the light loop comes to them. Lights behind the surface are most often
/// not asked for.
template <unsigned kFeatures>
void PathTracer<kFeatures>::look_ahead(const Surface& at, Frame& frame) const {
  frame.spots.resize(m_scene.lights().size());
  for_lights_of(*at.looks, [&](std::uint32_t i) {
    const LightBuffer* buffer = m_scene.light_buffer(i);
    frame.spots[i].known = buffer && !surely_behind(m_scene.lights()[i], at.point, at.normal);
    if (frame.spots[i].known) frame.spots[i] = buffer->spot_of(at.point);
  });
}

template <unsigned kFeatures>
Radiance PathTracer<kFeatures>::shade(const RayState& state, const Hit& hit, float weight,
                                      int level) {
  Surface at;
  at.state = &state;
  at.looks = &hit.leaf->attributes();
  at.interior = interior_of(*at.looks, hit.object);
  at.point = state.ray.at(hit.t);
  at.normal = hit.leaf->normal(at.point, hit.shape);
  at.depth = hit.t;
  at.weight = weight;
  at.level = level;
  const bool from_behind = dot(at.normal, state.ray.direction) > 0.0;
  if (from_behind) at.normal = -at.normal;
  at.context = {at.point, at.normal, state.ray.direction, &hit};
  at.texture_point = texture_point(at.context);
  Frame& frame = enter_frame();
  look_ahead(at, frame);

  if constexpr (kLayers) {
    textures_at(at.context, from_behind, m_bailout, frame.textures);
  } else {
    at.looks->texture->resolve(at.texture_point, at.context, 1.0, frame.textures);
  }
  Radiance sum;
  if (frame.textures.size() == 1 && frame.textures.front().weight == 1.0) {
    sum = shade_texture(*frame.textures.front().texture, at, frame);
  } else {
    for (const WeightedTexture& part : frame.textures) {
      const Radiance seen = shade_texture(*part.texture, at, frame);
      sum.rgb += times(seen.rgb, part.weight);
      sum.transmit += static_cast<float>(seen.transmit * part.weight);
    }
  }
  --m_depth;
  return sum;
}

template <unsigned kFeatures>
Radiance PathTracer<kFeatures>::shade_texture(const LayeredTexture& texture, const Surface& at,
                                              Frame& frame) {
  const auto& layers = texture.layers();
  Stack stack;
  stack.surface = at.context;
  if (frame.mirrors.size() < layers.size()) frame.mirrors.resize(layers.size());
  for (auto layer = layers.rbegin();
       layer != layers.rend() && stack.transparency > m_bailout; ++layer) {
    shade_layer(*layer, at, stack, frame.mirrors[stack.mirrors], frame);
    ++stack.mirrors;
  }
  Radiance result;
  result.rgb = stack.sum;
  bool total_reflection = false;
  if (kTransparency && stack.transparency > m_bailout) {
    total_reflection = add_transmitted(stack, at, result);
  }
  if constexpr (kReflection) {
    for (std::size_t i = 0; m_mirror_images && i < stack.mirrors; ++i) {
      const Mirror& mirror = frame.mirrors[i];
      if (mirror.colour.is_black()) continue;
      if (total_reflection && nearly_equal(stack.top_normal, mirror.normal)) continue;
      Rgb image = mirror_image(mirror.normal, mirror.weight, at, mirror.finish);
      if (mirror.exponent != 1.0) {
        for (int c = 0; c < 3; ++c) {
          image[c] = static_cast<float>(std::pow(image[c], mirror.exponent));
        }
      }
      result.rgb += mirror.colour * image;
    }
  }
  return result;
}

template <unsigned kFeatures>
void PathTracer<kFeatures>::shade_layer(const TextureLayer& layer, const Surface& at,
                                        Stack& stack, Mirror& mirror, Frame& frame) {
  const Finish& finish = layer.finish;
  const Colour* constant = layer.pigment->constant();
  const Colour colour =
      constant ? *constant : layer.pigment->colour(at.texture_point, stack.surface);
  const Vec3 normal = layer_normal(layer, stack.surface, at);
  if (layer.normal) stack.surface.normal = normal;
  if (stack.mirrors == 0) stack.top_normal = normal;

  if constexpr (kReflection) {
    mirror.colour = {};
    if (reflects(finish)) {
      const double cosine = -dot(at.state->ray.direction, normal);
      const double ior =
          finish.reflection_fresnel ? relative_ior(at.interior, at.state->inside) : 1.0;
      const Reflectivity share = reflectivity(finish, cosine, ior, colour.rgb);
      mirror.normal = normal;
      mirror.colour = share.colour;
      mirror.weight = static_cast<float>(at.weight * stack.transparency) * share.weight;
      mirror.exponent = 1.0 / finish.reflection_exponent;
      mirror.finish = &finish;
    }
  }

  const double opacity = kTransparency || kLayers ? opacity_of(colour, m_legacy_opacity) : 1.0;
  Rgb own = times(colour.rgb * finish.ambient * m_scene.settings().ambient_light, opacity);
  own += times(colour.rgb * finish.emission, opacity);
  own += lit(finish, colour.rgb, normal, opacity, at, frame);
  stack.sum += own * stack.filter;

  if constexpr (kTransparency || kLayers) {
    stack.filter *= passed(colour);
    if (kReflection && finish.conserve_energy) {
      stack.filter *= Rgb(std::min(1.0f, 1.0f - mirror.colour.r),
                          std::min(1.0f, 1.0f - mirror.colour.g),
                          std::min(1.0f, 1.0f - mirror.colour.b));
    }
    stack.transparency = std::min(1.0, static_cast<double>(std::fabs(grey(stack.filter))));
  } else {
    stack.transparency = 0.0;
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
  const bool front_only = !at.looks->double_illuminate && finish.diffuse_back == 0.0;
  for_lights_of(*at.looks, [&](std::uint32_t i) {
    const Light& light = m_scene.lights()[i];
    if (front_only && surely_behind(light, at.point, normal)) return;
    const LightRay ray = light_ray(light, at.point);
    Rgb colour = light_colour(light, at.point, ray);
    if (is_dark(colour)) return;
    bool behind = false;
    if (!at.looks->double_illuminate && dot(normal, ray.direction) < kTiny) {
      if (front_only) return;
      behind = true;
    }
    if (!light.shadowless) {
      colour = arriving(i, colour, ray, at, frame);
      if (is_dark(colour)) return;
    }
    const Illumination on{ray.direction, at.state->ray.direction, normal, colour, pigment,
                          opacity};
    Rgb share = diffuse_light(finish, on, behind ? finish.diffuse_back : finish.diffuse,
                              finish.crand > 0.0 ? random() : 0.0);
    if (!light.shadowless && !behind) share += highlights(finish, on);
    if (finish.irid > 0.0) {
      share *= film_tint(finish, film_thickness(finish, at.point),
                         m_scene.settings().irid_wavelength, normal, ray.direction, on.eye);
    }
    sum += share;
  });
  return sum;
}

template <unsigned kFeatures>
Rgb PathTracer<kFeatures>::arriving(std::uint32_t light, const Rgb& colour, const LightRay& ray,
                                    const Surface& at, Frame& frame) {
  if constexpr (kLayers) {
    if (frame.light_known[light]) return frame.light[light];
  }
  Rgb result;
  if constexpr (kArea) {
    result = m_scene.lights()[light].has_area ? area_shadowed(light, colour, ray, at)
                                              : shadowed(light, colour, ray, at, frame);
  } else {
    result = shadowed(light, colour, ray, at, frame);
  }
  if constexpr (kLayers) {
    frame.light[light] = result;
    frame.light_known[light] = 1;
  }
  return result;
}

template <unsigned kFeatures>
Rgb PathTracer<kFeatures>::shadowed(std::uint32_t light, const Rgb& colour, const LightRay& ray,
                                    const Surface& at, const Frame& frame) {
  ShadowQuery query;
  if (frame.spots[light].known) query.spot = &frame.spots[light];
  query.ray = {at.point, ray.direction};
  query.distance = ray.distance;
  query.light = light;
  query.depth = at.level;
  query.tree_place = at.state->place;
  query.column = m_pixel.column;
  query.row = m_pixel.row;
  query.inside = &at.state->inside;
  return colour * m_shadows.visibility(query).filter;
}

template <unsigned kFeatures>
Rgb PathTracer<kFeatures>::area_shadowed(std::uint32_t light, const Rgb& colour,
                                         const LightRay& ray, const Surface& at) {
  const Light& source = m_scene.lights()[light];
  ShadowQuery query;
  query.light = light;
  query.depth = at.level;
  query.tree_place = at.state->place;
  query.column = m_pixel.column;
  query.row = m_pixel.row;
  query.inside = &at.state->inside;
  auto probe = [&](const Vec3& offset, std::uint32_t sample) {
    const LightRay to_sample = light_ray(source, at.point, offset);
    query.ray = {at.point, to_sample.direction};
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
                                        const Finish* film) {
  const Vec3& incoming = at.state->ray.direction;
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
  RayState next({at.point, normalized(out)}, at.state->inside, 2 * at.state->place, true);
  Rgb seen = follow(next, weight, at.level).rgb;
  if (film && film->irid > 0.0) {
    seen *= film_tint(*film, film_thickness(*film, at.point), m_scene.settings().irid_wavelength,
                      normal, next.ray.direction, incoming);
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
  RayState next({at.point, at.state->ray.direction}, at.state->inside, 2 * at.state->place + 1,
                at.state->reflected);
  const double ratio = m_start_interiors ? enter(at.interior, next.inside) : 1.0;

  Rgb fade(1.0f);
  if (at.interior.interior && at.state->inside.contains(at.interior.key)) {
    fade = fade_in_interior(*at.interior.interior, at.depth);
  }
  Radiance seen;
  if (std::fabs(ratio - 1.0) < kTiny) {
    ++m_counters.refracted_rays;
    seen = follow(next, weight, at.level, true);
  } else {
    double cosine = dot(next.ray.direction, stack.top_normal);
    const Vec3 normal = cosine <= 0.0 ? stack.top_normal : -stack.top_normal;
    cosine = std::fabs(cosine);
    const double under_root = 1.0 + ratio * ratio * (cosine * cosine - 1.0);
    if (under_root < 0.0) {
      // Total internal reflection: the layers do not filter it.
      result.rgb += fade * mirror_image(stack.top_normal, weight, at, nullptr);
      return true;
    }
    next.ray.direction =
        next.ray.direction * ratio + normal * (ratio * cosine - std::sqrt(under_root));
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
  m_random_state = mixed(m_random_state);
  return static_cast<double>(m_random_state >> 11) * 0x1.0p-53;
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
