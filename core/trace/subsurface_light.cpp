#include "core/trace/subsurface_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/accel/hierarchy.h"
#include "core/base/tiny.h"
#include "core/material/fresnel.h"
#include "core/subsurface/dipole.h"
#include "core/subsurface/directions.h"
#include "core/subsurface/settings.h"
#include "core/trace/indirect_light.h"
#include "core/trace/random_key.h"
#include "core/trace/reflectance.h"
#include "core/trace/refraction.h"

namespace lentray::core {
namespace {

constexpr int kMostScattered = 2;      ///< from here on nothing is seen of a ray's subsurface light
constexpr double kLeastCosine = 0.01;  ///< at which a place is seen from below: limits its area
constexpr double kDirections = 0.75, kDepths = 0.25;  ///< even_ones()
constexpr double kPhase = 1.0 / 4.0;                  ///< isotropic, times pi as lights are
/// A place that sends on less of its light is dark: 300 such places of white light are not seen.
constexpr float kFaint = 1e-5f;

/// What passes a surface from outside: all where nothing does.
double transmittance(double cosine, double ior) {
  if (ior * ior + cosine * cosine < 1.0) return 1.0;
  return 1.0 - fresnel(cosine, ior);
}

/// How many evenly spread samples leave as much noise as `samples` random ones, of which the scene's numbers
/// speak. Up to four are all taken.
int even_ones(int samples, double share) {
  return std::max(std::min(samples, 4), static_cast<int>(std::ceil(samples * share)));
}

/// Of the refracted direction; not a number beyond the critical angle.
double inner_cosine(double cosine, double ior) {
  return std::sqrt(1.0 - (1.0 - cosine * cosine) / (ior * ior));
}

}  // namespace

struct SubsurfaceLight::Exit {
  const Surface& surface;
  std::uint64_t key;
  std::uintptr_t interior;  ///< its identity: InteriorEntry
  double ior;               ///< relative: of the solid over outside
  double cosine;            ///< of the eye
  double transmitted;       ///< the part of the light that passes on to the eye
  double mm;                ///< in a unit
  Scattering scattering;
  std::array<Dipole, 3> dipoles;
  LightLists lights;
};

/// Every light counts, from either side of the surface.
struct SubsurfaceLight::AllLights {
  const Vec3& normal;
  bool may_face(const LightSource&, const Vec3&) const { return true; }
  bool faces(const LightSource&, const Vec3& direction) const {
    return std::fabs(dot(normal, direction)) >= kTiny;
  }
};

/// Sums what passes the surface into the solid.
struct SubsurfaceLight::Receiver {
  const Vec3& point;
  const Vec3& normal;
  double ior;
  Rgb sum{};
  bool may_show(const IncomingLight&) const { return true; }
  void receive(const IncomingLight& incoming) {
    const double cosine = std::fabs(dot(normal, incoming.ray.direction));
    double part = cosine * transmittance(cosine, ior);
    // Lights shine as points: one that illuminates by its area has no cone and no fading yet.
    if (incoming.source->by_area) {
      part *= light_attenuation(incoming.source->light, point, incoming.ray);
    }
    sum += times(incoming.colour, part);
  }
};

SubsurfaceLight::SubsurfaceLight(ThreadContext& context, ShadowTester& shadows,
                                 const PathRules& rules)
    : m_context(context), m_settings(context.scene.settings()), m_rules(rules),
      m_min_distance(kMinHitDistance * context.scene.tolerance_scale()),
      m_lights(context, shadows, rules.area_lights), m_known(m_lights.lights()) {}

const ReducedAlbedo& SubsurfaceLight::albedo(double ior) {
  const auto found = std::find_if(m_albedos.begin(), m_albedos.end(),
                                  [&](const ReducedAlbedo& one) { return one.ior() == ior; });
  return found != m_albedos.end() ? *found : m_albedos.emplace_back(ior);
}

SubsurfaceLight::Exit SubsurfaceLight::exit_at(const Surface& surface,
                                               const SubsurfaceFinish& finish, const Rgb& pigment) {
  const InteriorEntry interior = surface.interior();
  const double atmosphere = m_settings.atmosphere_ior;
  const double ior = relative_ior(interior, m_context.interiors, surface.state.inside, atmosphere);
  const double cosine = std::clamp(-dot(surface.ray().direction, surface.normal), 0.0, 1.0);
  Exit exit{surface,
            branch_key(surface.state.key, surface.layer),
            interior.key,
            ior,
            cosine,
            transmittance(cosine, ior),
            m_settings.mm_per_unit,
            scattering_of(albedo(interior.ior(atmosphere)), times(pigment, finish.diffuse),
                          finish.translucency),
            {},
            m_lights.lights_of(surface.attributes)};
  const double factor = boundary_factor(ior);
  for (std::size_t c = 0; c < 3; ++c) {
    const double lost = exit.scattering.lost[c];
    if (lost > 0.0) exit.dipoles[c] = Dipole(exit.scattering.scattered[c], lost, factor);
  }
  return exit;
}

/// A ray in a solid. No kind of rays sees all objects; this one passes by those with no_radiosity alone.
bool SubsurfaceLight::nearest(const Ray& ray, double from, double to, Hit& hit) {
  // Blobs are not hit near to a ray's start, but, as in stock, near to that of a ray in a solid. So it
  // starts before.
  constexpr double kBefore = 0.02;
  const Ray before{ray.origin - ray.direction * kBefore, ray.direction};
  const bool is_met =
      m_context.scene.hierarchy().nearest(before, from + kBefore, to + kBefore, RayKind::kGather,
                                          hit, m_context.lists, m_context.tests);
  hit.t -= kBefore;
  return is_met;
}

Rgb SubsurfaceLight::at(const Surface& surface, const SubsurfaceFinish& finish, const Rgb& pigment,
                        const Rgb& share, UnscatteredRay& through) {
  through.left = {};
  if (surface.state.scattered >= kMostScattered) return {};
  const Exit exit = exit_at(surface, finish, pigment);
  if (!(exit.scattering.mean_lost > 0.0)) return {};
  const SubsurfaceSettings& wanted = *m_settings.subsurface;
  const bool is_first = surface.state.scattered == 0;
  Rgb light = scattered_often(exit, is_first ? wanted.samples_diffuse : 1, share);
  const auto direction = refracted(surface.ray().direction, surface.normal, 1.0 / exit.ior);
  if (!direction) return light;
  Hit behind;
  const bool ends = nearest({surface.point(), *direction}, m_min_distance, Bounds::kInf, behind);
  const double length = ends ? behind.t * exit.mm : std::numeric_limits<double>::infinity();
  light += scattered_once(exit, *direction, length, is_first ? wanted.samples_single : 1);
  if (ends) pass_through(exit, *direction, behind, through);
  return light;
}

/// Where directions begin: a mean free path deep, but in what is thin no deeper than its middle.
Vec3 SubsurfaceLight::below(const Exit& exit) {
  const Surface& surface = exit.surface;
  const Vec3 inwards = -surface.normal;
  double depth = 1.0 / (exit.scattering.mean_lost * exit.mm);
  Hit other;
  if (nearest({surface.point(), inwards}, m_min_distance, 2.0 * depth, other)) {
    const bool is_same = interior_of(other.leaf->attributes(), other.object).key == exit.interior;
    depth = std::min(depth, is_same ? other.t / 2.0 : other.t - kTiny);
  }
  return surface.point() + inwards * depth;
}

Rgb SubsurfaceLight::scattered_often(const Exit& exit, int samples, const Rgb& share) {
  const bool by_others =
      m_settings.subsurface->radiosity && m_context.indirect && m_context.indirect->is_wanted();
  if (samples <= 0 || (!m_rules.lights && !by_others)) return {};
  samples = even_ones(samples, kDirections);
  const Surface& surface = exit.surface;
  SphereDirections directions(samples,
                              spiral_start(surface.layer == 0 ? surface.state.key : exit.key));
  Ray ray{below(exit), {}};
  Rgb sum;
  int met = 0;
  m_asked.clear();
  for (int i = 0; i < samples; ++i) {
    ray.direction = directions.next();
    Hit hit;
    if (!nearest(ray, 0.0, Bounds::kInf, hit)) continue;
    ++met;
    if (interior_of(hit.leaf->attributes(), hit.object).key != exit.interior) continue;
    const Vec3 point = ray.at(hit.t), normal = hit.leaf->normal(point, hit.shape);
    const double distance = hit.t * exit.mm;
    const double area = 4.0 * std::numbers::pi * distance * distance /
                        std::max(kLeastCosine, std::fabs(dot(normal, ray.direction)));
    const Rgb leaves = leaving(exit, point, area);
    if (by_others) sum += indirectly(exit, point, normal, area, leaves);
    if (m_rules.lights && greatest(leaves) > kFaint) {
      sum += leaves * entering(exit, point, normal, exit.lights,
                               branch_key(exit.key, static_cast<std::uint64_t>(i)));
    }
  }
  if (met == 0) return {};
  const float part = 1.0f / static_cast<float>(met);
  for (const AskedQuery& asked : m_asked) {
    m_context.indirect->take_share(asked.number, asked.share * share * part,
                                   exit.surface.state.kind == RayKind::kGather);
  }
  return sum * part;
}

/// The part of the light that enters there which leaves at the exit.
Rgb SubsurfaceLight::leaving(const Exit& exit, const Vec3& point, double area) const {
  const double distance_squared = length_squared(point - exit.surface.point()) * exit.mm * exit.mm;
  const double factor = area * exit.transmitted;
  const auto channel = [&](std::size_t c) {
    return static_cast<float>(factor * exit.dipoles[c].at(distance_squared));
  };
  return {channel(0), channel(1), channel(2)};
}

/// Of lights, into the solid.
Rgb SubsurfaceLight::entering(const Exit& exit, const Vec3& point, const Vec3& normal,
                              const LightLists& lights, std::uint64_t key) {
  Receiver receiver{point, normal, exit.ior};
  const RayState& state = exit.surface.state;
  m_lights.at({point, exit.surface.level, state.tree_place, InteriorsId::kOpen, key}, lights,
              m_known, AllLights{normal}, receiver);
  return receiver.sum;
}

/// Of other surfaces. Their light is weighed by cosines already: it enters as if it came straight.
Rgb SubsurfaceLight::indirectly(const Exit& exit, const Vec3& point, const Vec3& normal,
                                double area, const Rgb& leaves) {
  const IndirectAnswer answer = m_context.indirect->at(
      {point, normal, normal, area, static_cast<std::uint8_t>(exit.surface.state.scattered + 1)});
  const Rgb share = times(leaves, transmittance(1.0, exit.ior));
  m_asked.push_back({answer.number, share});
  return share * answer.light;
}

Rgb SubsurfaceLight::scattered_once(const Exit& exit, const Vec3& direction, double length,
                                    int samples) {
  if (samples <= 0 || !m_rules.lights) return {};
  RandomSequence random(mixed(exit.key), RandomSequence::Use::kSubsurface);
  const int places = even_ones(samples, kDepths);
  Rgb sum;
  for (int i = 0; i < places; ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      const double lost = exit.scattering.lost[c];
      if (!(lost > 0.0)) continue;
      const double depth = -std::log((i + random.next()) / places) / lost;
      if (!(depth < length)) continue;
      const std::uint64_t number = (std::uint64_t{1} << 32) + 3 * static_cast<std::uint64_t>(i) + c;
      const Vec3 inner = exit.surface.point() + direction * (depth / exit.mm);
      for (const std::span<const std::uint32_t> list : exit.lights) {
        for (const std::uint32_t& light : list) {
          sum[static_cast<int>(c)] +=
              of_one(exit, {inner, depth, c}, light, branch_key(exit.key, number));
        }
      }
    }
  }
  return sum * (1.0f / static_cast<float>(places));
}

/// Light of one source that is scattered at an inner place, where it comes straight through the surface.
float SubsurfaceLight::of_one(const Exit& exit, const InnerPlace& place, const std::uint32_t& light,
                              std::uint64_t key) {
  const Ray to_light{place.point,
                     light_ray(m_context.scene.lights()[light], place.point).direction};
  Hit hit;
  if (!nearest(to_light, 0.0, Bounds::kInf, hit)) return 0.0f;
  if (interior_of(hit.leaf->attributes(), hit.object).key != exit.interior) return 0.0f;
  const Vec3 point = to_light.at(hit.t), normal = hit.leaf->normal(point, hit.shape);
  const double cosine = std::fabs(dot(normal, to_light.direction));
  const double inside = inner_cosine(cosine, exit.ior);
  if (!(inside > kTiny)) return 0.0f;
  const double lost = exit.scattering.lost[place.channel];
  const double way = hit.t * exit.mm * cosine / inside;  // as if it were bent at the surface
  const double both = lost + inner_cosine(exit.cosine, exit.ior) / inside * lost;
  const double part = exit.scattering.scattered[place.channel] * kPhase / both * exit.transmitted *
                      std::exp(-(way + place.depth) * lost);
  if (!(part > kFaint)) return 0.0f;
  const Rgb entered = entering(exit, point, normal, {{{&light, 1}, {}}}, key);
  return static_cast<float>(part) * entered[static_cast<int>(place.channel)];
}

void SubsurfaceLight::pass_through(const Exit& exit, const Vec3& direction, const Hit& behind,
                                   UnscatteredRay& through) const {
  const auto left = [&](std::size_t c) {
    const double lost = exit.scattering.lost[c];
    return lost > 0.0 ? static_cast<float>(std::exp(-lost * behind.t * exit.mm)) : 0.0f;
  };
  const Rgb all{left(0), left(1), left(2)};
  if (!(greatest(all) > m_rules.adc_bailout)) return;
  if (interior_of(behind.leaf->attributes(), behind.object).key != exit.interior) return;
  through.ray.origin = exit.surface.point() + direction * behind.t;
  const Vec3 normal = behind.leaf->normal(through.ray.origin, behind.shape);
  if (const auto outside = refracted(direction, normal, exit.ior)) {
    through.ray.direction = *outside;
    through.left = all;
  }
}

}  // namespace lentray::core
