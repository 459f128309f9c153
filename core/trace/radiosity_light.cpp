#include "core/trace/radiosity_light.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/base/damaged_record.h"
#include "core/trace/path_rules.h"
#include "core/trace/random_key.h"
#include "core/trace/thread_context.h"

namespace lentray::core {
namespace {

constexpr double kSamplesAWeight = 4.0;  ///< a sum of weights of 1 counts as so many samples

/// Of the place and what the answer depends on.
std::uint64_t hash_of(const IndirectQuery& query) {
  std::uint64_t hash = std::bit_cast<std::uint64_t>(query.weight);
  for (const Vec3* v : {&query.point, &query.surface_normal, &query.layer_normal}) {
    for (const double x : {v->x, v->y, v->z}) hash = mixed(hash ^ std::bit_cast<std::uint64_t>(x));
  }
  return hash;
}

/// What samples gave with what was gathered besides, each by its weight.
Reuse joined(const Reuse& found, const GatheredLight& more) {
  if (!(found.weight > 0.0)) return {more.quality, more.light};
  const double all = found.weight + more.quality;
  return {all, (found.light * static_cast<float>(found.weight) +
                more.light * static_cast<float>(more.quality)) *
                   (1.0f / static_cast<float>(all))};
}

/// As the scene wants it: by gray_threshold and brightness.
Rgb toned(const Rgb& light, const RadiositySettings& settings) {
  const auto greyness = static_cast<float>(settings.gray_threshold);
  const auto brightness = static_cast<float>(settings.brightness);
  if (!(greyness > 0.0f)) return light * brightness;
  return (light * (1.0f - greyness) + Rgb(greyness * grey(light))) * brightness;
}

}  // namespace

Integrator make_gatherer(ThreadContext& context, ShadowTester& shadows) {
  const RadiositySettings& settings = *context.scene.settings().radiosity;
  PathRules rules{settings.adc_bailout};
  rules.highlights = false;
  rules.area_lights = false;
  rules.subsurface = settings.subsurface;
  rules.volumes = settings.media;
  return Integrator(context, shadows, rules);
}

RadiosityLight::RadiosityLight(ThreadContext& context, ShadowTester& shadows,
                               const IrradianceCache& cache, IrradianceCache* growing, bool is_last,
                               GatherTeam* team)
    : m_context(context), m_cache(cache), m_growing(growing), m_settings(cache.settings()),
      m_is_last(is_last), m_rays(make_gatherer(context, shadows)), m_team(team),
      m_counts(static_cast<std::size_t>(cache.depths())) {
  for (int depth = 0; depth < cache.depths(); ++depth) {
    m_depths.push_back(
        {rules_at(m_settings, depth), cache.directions(), SampleLookup(cache, depth, is_last)});
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
  m_answered.clear();
  m_answers = 0;
  m_known = 0;
  m_gathers = 0;
  m_key = key;
  m_sight = is_centre && !m_growing ? m_cache.sight(pixel) : PixelSight{};
}

IndirectAnswer RadiosityLight::answer(const IndirectQuery& query, const EarlyReuse& early) {
  if (m_depth > 0) return found_out(query, early);
  if (!m_growing) {
    const KnownAnswer* known = known_answer(query);
    return known ? IndirectAnswer{known->light} : found_out(query, early);
  }
  const std::size_t gathered = m_gathered.size();
  const IndirectAnswer found = found_out(query, early);
  m_answered.push_back({hash_of(query), found.light, m_gathered.size() > gathered});
  return found;
}

const KnownAnswer* RadiosityLight::known_answer(const IndirectQuery& query) {
  if (m_known >= m_sight.answers.size()) return nullptr;
  const KnownAnswer& next = m_sight.answers[m_known];
  if (next.query != hash_of(query)) return nullptr;
  ++m_known;
  if (next.was_gathered) next_gathered();
  return &next;
}

const GatheredLight& RadiosityLight::next_gathered() {
  const GatheredLight& next = (*m_sight.gathered)[m_answers++];
  if (next.is_kept) ++m_sight.samples;
  return next;
}

IndirectAnswer RadiosityLight::found_out(const IndirectQuery& query, const EarlyReuse& early) {
  const Vec3& normal = here().lookup.normal_of(query);
  Reuse known = reuse(query, early);
  if (!is_enough(known)) {
    const double before = m_quality;
    const GatheredLight more = gathered_for(query, normal);
    m_quality = std::max(before, more.quality);
    known = joined(known, more);
  }
  m_quality = std::min(m_quality, kSamplesAWeight * known.weight / here().rules.wanted);
  return {toned(known.light, m_settings)};
}

Reuse RadiosityLight::reuse(const IndirectQuery& query, const EarlyReuse& early) {
  const SampleLookup& lookup = here().lookup;
  const Reuse found = m_growing
                          ? lookup.find(query, early)
                          : lookup.find(query, m_depth == 0 ? m_sight.samples : SampleStore::kAll);
  GatherCounts& counts = m_counts[static_cast<std::size_t>(m_depth)];
  ++counts.queries;
  counts.found += kSamplesAWeight * found.weight;
  return found;
}

bool RadiosityLight::is_enough(const Reuse& found) const {
  if (m_is_last && !m_settings.always_sample && found.weight > 0.0) return true;
  return kSamplesAWeight * found.weight >= m_depths[static_cast<std::size_t>(m_depth)].rules.wanted;
}

/// What the pass gathered for the pixel, if it did; else what is gathered now.
GatheredLight RadiosityLight::gathered_for(const IndirectQuery& query, const Vec3& normal) {
  if (m_depth > 0) return gather(query, normal);
  if (m_sight.gathered && m_answers < m_sight.gathered->size()) return next_gathered();
  if (!m_growing) {  // what other places gathered must not count
    for (Depth& depth : m_depths) depth.cycle.begin_at(mixed(m_key ^ m_gathers));
  }
  if (!m_growing) return gather(query, normal);
  const GatheredLight light = gather_or_recall(query, normal);
  m_gathered.push_back(light);
  return light;
}

/// A pass does again what an earlier run of it did, but for the rays.
GatheredLight RadiosityLight::gather_or_recall(const IndirectQuery& query, const Vec3& normal) {
  GatherState state;
  if (std::string record; m_team->recall(record)) {
    if (!take_gather(record, state, *m_growing)) throw DamagedRecord();
    for (std::size_t i = 0; i < m_depths.size(); ++i) m_depths[i].cycle.begin_at(state.places[i]);
    m_counts = state.counts;
    m_gathers = state.gathers;
    m_importance = state.importance;
    m_has_gathered = true;
    return state.light;
  }
  const std::vector<std::size_t> before = sizes_of(m_cache);
  state.light = gather(query, normal);
  state.gathers = m_gathers;
  state.importance = m_importance;
  for (const Depth& depth : m_depths) state.places.push_back(depth.cycle.place());
  state.counts = m_counts;
  m_team->keep(bytes_of(state, m_cache, before));
  return state.light;
}

GatheredLight RadiosityLight::gather(const IndirectQuery& query, const Vec3& normal) {
  const unsigned about_surface = aim(query, normal);
  shoot();
  m_has_gathered = true;
  const GatherSum sum = sum_up();
  GatherCounts& counts = m_counts[static_cast<std::size_t>(m_depth)];
  ++counts.gathers;
  counts.rays += sum.rays();
  GatheredLight light{sum.light(), sum.quality()};
  const bool by_surface = !m_settings.normal || 2 * about_surface > sum.rays();
  light.is_kept =
      m_growing && keep(query.point, by_surface ? query.surface_normal : query.layer_normal, sum);
  if (!light.is_kept) ++counts.not_kept;
  return light;
}

/// How many of the rays are about the surface's own normal.
unsigned RadiosityLight::aim(const IndirectQuery& query, const Vec3& normal) {
  Depth& depth = here();
  const DepthRules& rules = depth.rules;
  GatherDirections directions(depth.cycle, query.surface_normal, normal, rules.rays);
  const std::uint64_t key = mixed(m_key ^ mixed(m_gathers++));
  GatherRay ray{{query.point, {}}, static_cast<float>(rules.gather_weight), rules.gather_level};
  ray.scattered = query.scattered;
  depth.rays.clear();
  unsigned about_surface = 0;
  for (unsigned i = 0; i < rules.rays && directions.next(ray.ray.direction); ++i) {
    if (directions.about_surface()) ++about_surface;
    ray.least_importance = static_cast<float>(i) / static_cast<float>(rules.rays - 1);
    ray.key = part_key(key, i);
    depth.rays.push_back(ray);
  }
  return about_surface;
}

/// The rays that only ask at their first surface are traced beforehand. Media may dim what comes from there.
void RadiosityLight::shoot() {
  Depth& depth = here();
  depth.records.resize(std::max(depth.records.size(), depth.rays.size()));
  depth.qualities.assign(depth.rays.size(), 1.0);
  const bool asks = m_depth + 1 < m_cache.depths();
  const SampleLookup* const asked =
      asks ? &m_depths[static_cast<std::size_t>(m_depth) + 1].lookup : nullptr;
  if (m_team) m_team->trace(depth.rays, asked, {depth.records.data(), depth.rays.size()});
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
      for (const RecordedQuery& noted : record.queries) {
        record.seen.light += noted.share * at(noted).light;
      }
    } else {
      record.seen = m_rays.gather(depth.rays[i]);
      if (!m_has_gathered) m_importance = record.seen.importance;
    }
    depth.qualities[i] = m_quality;
    // What the last ray of gathers on its way met counts for a ray.
    record.seen.importance = m_importance;
  }
  --m_depth;
}

GatherSum RadiosityLight::sum_up() {
  const Depth& depth = here();
  GatherSum sum(depth.rules.rays, m_settings.max_sample);
  for (std::size_t i = 0; i < depth.rays.size(); ++i) {
    sum.add(depth.rays[i], depth.records[i].seen, depth.qualities[i]);
  }
  return sum;
}

/// Makes a sample of it unless something is so near that it would serve no other place.
bool RadiosityLight::keep(const Vec3& point, const Vec3& normal, const GatherSum& sum) {
  constexpr double kTooNear = 1e-4;  ///< of the greatest length of reuse
  const double unit = length(m_cache.eye() - point) * here().rules.error_factor;
  const double least = unit * m_settings.minimum_reuse, most = unit * m_settings.maximum_reuse;
  if (sum.rays() == 0 || !is_finite(point) || !std::isfinite(most)) return false;
  const auto radius = static_cast<float>(std::min(most, std::max(least, sum.mean_distance())));
  if (!(sum.nearest() > kTooNear * most) || !(radius > 0.0f)) return false;
  m_growing->store(m_depth).add({point, normal, sum.to_nearest(), sum.light(), radius,
                                 static_cast<float>(sum.nearest()),
                                 static_cast<float>(sum.quality())});
  return true;
}

}  // namespace lentray::core
