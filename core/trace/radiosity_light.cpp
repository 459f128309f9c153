#include "core/trace/radiosity_light.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/trace/path_rules.h"
#include "core/trace/random_key.h"
#include "core/trace/thread_context.h"

namespace lentray::core {
namespace {

constexpr double kSamplesAWeight = 4.0;  ///< a sum of weights of 1 counts as so many samples
constexpr double kLowWeight = 0.25;      ///< of a ray, from which on errors are borne more easily
constexpr double kNowhereNear = 2e10;    ///< the distance of the nearest thing if there is none
constexpr double kTooNear = 1e-4;        ///< of the greatest length of reuse

double greatest_channel(const Rgb& c) { return std::max({c.r, c.g, c.b}); }

}  // namespace

std::unique_ptr<Integrator> make_gatherer(ThreadContext& context, ShadowTester& shadows) {
  const RadiositySettings& settings = *context.scene.settings().radiosity;
  PathRules rules{settings.adc_bailout};
  rules.highlights = false;
  rules.area_lights = false;
  rules.subsurface = settings.subsurface;
  rules.volumes = settings.media;
  return Integrator::make(context, shadows, rules);
}

struct RadiosityLight::Sum {
  unsigned rays = 0, about_surface = 0;
  double quality = 0.0, inverse_distances = 0.0;
  double red = 0.0, green = 0.0, blue = 0.0;  ///< times the qualities
  double nearest = kNowhereNear;
  Vec3 to_nearest;

  void add(const Rgb& light, double share) {
    quality += share;
    red += share * light.r;
    green += share * light.g;
    blue += share * light.b;
  }
  void meet(const Vec3& direction, double distance) {
    if (distance < nearest) {
      nearest = distance;
      to_nearest = direction;
    }
    inverse_distances += 1.0 / distance;
  }
  Rgb light() const {
    const double whole = quality == 0.0 ? 1.0 : quality;
    return {static_cast<float>(red / whole), static_cast<float>(green / whole),
            static_cast<float>(blue / whole)};
  }
};

RadiosityLight::RadiosityLight(ThreadContext& context, ShadowTester& shadows,
                               const IrradianceCache& cache, IrradianceCache* growing, bool is_last,
                               GatherTeam* team)
    : m_context(context), m_cache(cache), m_growing(growing), m_settings(cache.settings()),
      m_is_last(is_last),
      m_error_bound(m_settings.error_bound * (is_last ? 1.0 : m_settings.low_error_factor)),
      m_rays(make_gatherer(context, shadows)), m_team(team),
      m_counts(static_cast<std::size_t>(cache.depths())) {
  for (int depth = 0; depth < cache.depths(); ++depth) {
    m_depths.push_back({rules_at(m_settings, depth), cache.directions()});
  }
}

RadiosityLight::RadiosityLight(ThreadContext& context, ShadowTester& shadows,
                               const IrradianceCache& cache)
    : RadiosityLight(context, shadows, cache, nullptr, true, nullptr) {}

RadiosityLight::RadiosityLight(ThreadContext& context, ShadowTester& shadows,
                               IrradianceCache& cache, bool is_last, GatherTeam& team)
    : RadiosityLight(context, shadows, cache, &cache, is_last, &team) {}

RadiosityLight::~RadiosityLight() = default;

void RadiosityLight::begin(Pixel pixel, bool is_centre, std::uint64_t key) {
  m_gathered.clear();
  m_answers = 0;
  m_gathers = 0;
  m_key = key;
  m_sight = is_centre && !m_growing ? m_cache.sight(pixel) : PixelSight{};
}

IndirectAnswer RadiosityLight::at(const IndirectQuery& query) {
  const DepthRules& rules = here().rules;
  ++m_counts[static_cast<std::size_t>(m_depth)].queries;
  const Vec3& normal = m_settings.normal ? query.layer_normal : query.surface_normal;
  double error = m_error_bound;
  if (query.weight < kLowWeight) error += kLowWeight - query.weight;
  const ReuseQuery place{query.point, normal, error * rules.error_factor,
                         m_is_last && m_depth == 0};
  Reuse found =
      m_cache.store(m_depth).find(place, m_depth == 0 ? m_sight.samples : SampleStore::kAll);
  m_counts[static_cast<std::size_t>(m_depth)].found += kSamplesAWeight * found.weight;
  const bool enough = kSamplesAWeight * found.weight >= rules.wanted ||
                      (m_is_last && !m_settings.always_sample && found.weight > 0.0);
  if (!enough) {
    const double before = m_quality;
    const GatheredLight more = gathered_for(query, normal);
    m_quality = std::max(before, more.quality);
    const auto all = static_cast<float>(found.weight + more.quality);
    if (found.weight > 0.0) {
      found.light = (found.light * static_cast<float>(found.weight) +
                     more.light * static_cast<float>(more.quality)) *
                    (1.0f / all);
    } else {
      found.light = more.light;
    }
    found.weight += more.quality;
  }
  m_quality = std::min(m_quality, kSamplesAWeight * found.weight / rules.wanted);
  Rgb light = found.light;
  if (m_settings.gray_threshold > 0.0) {
    const auto share = static_cast<float>(m_settings.gray_threshold);
    light = light * (1.0f - share) + Rgb(share * grey(light));
  }
  return {light * static_cast<float>(m_settings.brightness)};
}

/// What the pass gathered for the pixel, if it did; else what is gathered now.
GatheredLight RadiosityLight::gathered_for(const IndirectQuery& query, const Vec3& normal) {
  if (m_depth > 0) return gather(query, normal);
  if (m_sight.gathered && m_answers < m_sight.gathered->size()) {
    const GatheredLight& known = (*m_sight.gathered)[m_answers++];
    if (known.is_kept) ++m_sight.samples;
    return known;
  }
  if (!m_growing) {  // what other places gathered must not count
    for (Depth& depth : m_depths) depth.cycle.begin_at(mixed(m_key ^ m_gathers));
  }
  const GatheredLight light = gather(query, normal);
  if (m_growing) m_gathered.push_back(light);
  return light;
}

GatheredLight RadiosityLight::gather(const IndirectQuery& query, const Vec3& normal) {
  Sum sum;
  aim(query, normal, sum);
  shoot();
  m_has_gathered = true;
  add_up(sum);
  GatherCounts& counts = m_counts[static_cast<std::size_t>(m_depth)];
  ++counts.gathers;
  counts.rays += sum.rays;
  GatheredLight light;
  light.light = sum.light();
  light.quality = sum.rays > 0 ? sum.quality / sum.rays : 0.0;
  light.is_kept = m_growing && sum.rays > 0 && keep(query, sum, light);
  if (!light.is_kept) ++counts.not_kept;
  return light;
}

void RadiosityLight::aim(const IndirectQuery& query, const Vec3& normal, Sum& sum) {
  Depth& depth = here();
  const DepthRules& rules = depth.rules;
  GatherDirections directions(depth.cycle, query.surface_normal, normal, rules.rays);
  const std::uint64_t key = mixed(m_key ^ mixed(m_gathers++));
  GatherRay ray{{query.point, {}}, static_cast<float>(rules.gather_weight), rules.gather_level};
  ray.scattered = query.scattered;
  depth.rays.clear();
  for (unsigned i = 0; i < rules.rays && directions.next(ray.ray.direction); ++i) {
    if (directions.about_surface()) ++sum.about_surface;
    ray.least_importance = static_cast<float>(i) / static_cast<float>(rules.rays - 1);
    ray.key = part_key(key, i);
    depth.rays.push_back(ray);
  }
  sum.rays = static_cast<unsigned>(depth.rays.size());
}

/// The rays that only ask at their first surface are traced beforehand. Media may dim what comes from there.
void RadiosityLight::shoot() {
  Depth& depth = here();
  depth.records.resize(std::max(depth.records.size(), depth.rays.size()));
  depth.qualities.assign(depth.rays.size(), 1.0);
  const bool asks = m_depth + 1 < m_cache.depths();
  if (m_team) m_team->trace(depth.rays, asks, {depth.records.data(), depth.rays.size()});
  if (m_team && !asks) {
    if (!depth.rays.empty()) m_importance = depth.records[depth.rays.size() - 1].seen.importance;
    return;
  }
  ++m_depth;
  for (std::size_t i = 0; i < depth.rays.size(); ++i) {
    m_quality = 1.0;
    m_has_gathered = false;
    GatherRecord& record = depth.records[i];
    if (m_team && record.is_whole && !m_settings.media) {
      m_importance = record.seen.importance;
      for (const RecordedQuery& asked : record.queries) {
        record.seen.light += asked.share * at(asked.query).light;
      }
    } else {
      record.seen = m_rays->gather(depth.rays[i]);
      if (!m_has_gathered) m_importance = record.seen.importance;
    }
    depth.qualities[i] = m_quality;
    // As in stock, what the last ray of gathers on its way met counts for a ray.
    record.seen.importance = m_importance;
  }
  --m_depth;
}

void RadiosityLight::add_up(Sum& sum) {
  const Depth& depth = here();
  const double all = depth.rules.rays;
  for (std::size_t i = 0; i < depth.rays.size(); ++i) {
    const GatherRay& ray = depth.rays[i];
    const GatheredRay& seen = depth.records[i].seen;
    sum.meet(ray.ray.direction, seen.distance);
    if (seen.importance < ray.least_importance) continue;
    double share = depth.qualities[i];
    if (seen.importance < 1.0f) share *= all / (std::floor(seen.importance * (all - 1.0)) + 1.0);
    const double most = greatest_channel(seen.light);
    const bool is_much = m_settings.max_sample > 0.0 && most > m_settings.max_sample;
    sum.add(is_much ? seen.light * static_cast<float>(m_settings.max_sample / most) : seen.light,
            share);
  }
}

/// Makes a sample of it unless something is so near that it would serve no other place.
bool RadiosityLight::keep(const IndirectQuery& query, const Sum& sum, GatheredLight& light) {
  const double factor = length(m_cache.eye() - query.point) * here().rules.error_factor;
  const double most = factor * m_settings.maximum_reuse;
  if (!(sum.nearest > most * kTooNear) || !is_finite(query.point) || !std::isfinite(most)) {
    return false;
  }
  double radius = sum.inverse_distances > 0.0 ? sum.rays / sum.inverse_distances
                                              : std::numeric_limits<double>::infinity();
  radius = std::min(std::max(radius, factor * m_settings.minimum_reuse), most);
  if (!(static_cast<float>(radius) > 0.0f)) return false;
  const bool about_surface = !m_settings.normal || sum.about_surface > sum.rays - sum.about_surface;
  m_growing->store(m_depth).add(
      {query.point, about_surface ? query.surface_normal : query.layer_normal, sum.to_nearest,
       light.light, static_cast<float>(radius), static_cast<float>(sum.nearest),
       static_cast<float>(light.quality)});
  return true;
}

}  // namespace lentray::core
