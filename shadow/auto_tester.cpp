#include "shadow/auto_tester.h"

#include <algorithm>
#include <limits>

#include "core/scene/scene.h"

namespace lentray::shadow {
namespace {

// Rays of a light.
constexpr std::uint32_t kFirstPeriod = 256;
constexpr std::uint32_t kMostPeriod = 1u << 14, kMostCached = 1u << 11;
/// Samples a period, and every how many of them the search is measured where it is dark (else the first
/// alone). With a cache its own counts tell the rest.
constexpr std::uint32_t kRow = 16, kMeasured = 8, kRowCached = 8;

// In units of core/accel/test_cost.h.
constexpr double kDear = 4000.0;  ///< a search beside which no cache's own cost matters
constexpr double kSamplesCost = 2e5;  ///< of searches in a period: beside that samples are little
/// For each object: the grid asks them all where they are when it begins.
constexpr double kSetUp = 24.0;

constexpr double kAtALoss = 0.02;  ///< what it may cost before it is given up
constexpr double kLarge = 0.06;    ///< the same after a single period
constexpr std::uint32_t kToFill = 8;  ///< periods; an empty grid has no hits
/// Of rays that are blocked and the neighbourhood has no hit for: those that its cells have one for.
/// And probes in vain of those that ask them.
constexpr double kCellHits = 0.6, kCellMisses = 0.6;
constexpr double kMissesAsked = 1.7;  ///< probes of the neighbourhood that sent one on to the cells
constexpr double kOlder = 0.875;      ///< what counts of the period before
constexpr std::int64_t kForever = std::numeric_limits<std::int64_t>::max();

double since(std::uint64_t now, std::uint64_t then) { return static_cast<double>(now - then); }

}  // namespace

bool AutoTester::Choice::decide(bool promising, bool steady) {
  ++periods;
  const bool losing = !steady || saved <= -(periods < least ? kLarge : kAtALoss) * searched;
  const bool other = on ? losing : periods >= wait && promising && steady;
  if (other) {
    if (on) wait *= 2;
    on = !on;
    periods = 0;
    saved = searched = 0.0;
  }
  saved *= kOlder;
  searched *= kOlder;
  return other;
}

AutoTester::AutoTester(const core::ShadowContext& context)
    : m_plain(context, true), m_counting(context.count_tests ? context.counters : nullptr),
      m_measures(m_counting ? m_counting : &m_own),
      m_cascade(*context.scene), m_objects(context.scene->objects().size()),
      m_watches(context.scene->lights().size()),
      m_modes(m_watches.size()), m_alone(m_watches.size(), kFirstPeriod - kRow) {
  m_own.by_type = false;
  for (Watch& watch : m_watches) {
    watch.period = kFirstPeriod;
    watch.samples = kRow;
    watch.cells.least = kToFill;
  }
  for (std::size_t i = 0; i < m_alone.size(); ++i) {
    if (context.scene->light_buffer(i)) m_alone[i] = kForever;
  }
}

core::Visibility AutoTester::attended(const core::ShadowQuery& query) {
  core::ShadowCounts& counts = m_plain.context().counters->lights[query.light];
  Mode& mode = m_modes[query.light];
  if (counts.rays >= mode.until) [[unlikely]] return watched(query, counts);
  ++counts.rays;
  ++counts.cached;
  const auto vain = [&mode](const Tried& tried) { mode.vain += tried.test_cost(); };
  if (mode.part == Part::kAround) {
    return visibility_by(m_cascade.around(), query, m_plain, counts, vain);
  }
  if (mode.part == Part::kCascade) return visibility_by(m_cascade, query, m_plain, counts, vain);
  return visibility_by(*m_grid, query, m_plain, counts, vain);
}

/// The samples, and the first ray of the next period.
core::Visibility AutoTester::watched(const core::ShadowQuery& query, core::ShadowCounts& counts) {
  Watch& watch = m_watches[query.light];
  if (watch.taken == watch.samples) {
    begin_period(query.light, watch, counts);
    return visibility(query);  // the first one
  }
  if (watch.taken == 0) {
    watch.known.begin_row();
    if (watch.cached()) count(query.light, watch, counts);
  }
  return sampled(query, watch, counts);
}

core::Visibility AutoTester::sampled(const core::ShadowQuery& query, Watch& watch,
                                     core::ShadowCounts& counts) {
  const bool measured = watch.cached() || watch.taken == 0 ||
                        (watch.taken % kMeasured == 0 && watch.known.dark());
  ++watch.taken;
  ++counts.rays;
  const double cost = m_measures->test_cost;
  const core::Visibility seen = m_plain.search(query, measured ? m_measures : m_counting);
  if (seen.blocker) ++counts.blocked;
  watch.known.add(query.tree_place, seen.blocker);
  if (measured) {
    ++counts.measured;
    watch.known.add_cost(m_measures->test_cost - cost, seen.blocker);
  }
  if (watch.cached()) remember(query, watch, seen.blocker);
  return seen;
}

void AutoTester::remember(const core::ShadowQuery& query, const Watch& watch,
                          const core::Object* blocker) {
  if (watch.grid.on) {
    m_grid->searched(query, {}, blocker);
  } else if (watch.cells.on) {
    m_cascade.searched(query, m_cascade.spot(query), blocker);
  } else {
    m_cascade.around().searched(query, m_cascade.spot(query), blocker);
  }
}

void AutoTester::begin_period(std::uint32_t light, Watch& watch,
                              const core::ShadowCounts& counts) {
  const bool was_cached = watch.cached();
  if (decide(watch, counts.rays)) {
    watch.period = kFirstPeriod;
  } else if (watch.cascade.periods >= 2 || watch.grid.on) {
    const double most = std::min(kSamplesCost / watch.known.search(),
                                 1.0 * (was_cached ? kMostCached : kMostPeriod));
    watch.period = std::min(2 * watch.period, static_cast<std::uint32_t>(
                                                  std::max(most, 2.0 * kFirstPeriod)));
  }
  watch.known.grow_old();
  watch.samples = watch.cached() ? kRowCached : kRow;
  watch.taken = 0;
  const std::uint32_t others = watch.period - watch.samples;
  m_alone[light] = watch.cached() ? 0 : others;
  m_modes[light] = {counts.rays + others, watch.grid.on    ? Part::kGrid
                                          : watch.cells.on ? Part::kCascade
                                                           : Part::kAround};
  if (watch.grid.on && !m_grid) m_grid.emplace(*m_plain.context().scene);
  const Cascade::GridUse& use = m_cascade.grid_use(light);
  watch.before = {counts.blocked, counts.hits, counts.misses, use.asked, use.hits, use.misses};
}

/// What the caches saved in the period.
void AutoTester::count(std::uint32_t light, Watch& watch, const core::ShadowCounts& counts) {
  const Before& before = watch.before;
  const double rays = watch.period - watch.samples, searched = rays * watch.known.search();
  const double hits = since(counts.hits, before.hits), misses = since(counts.misses, before.misses);
  const double hit = watch.known.hit();
  const double probe = kProbeCost + (misses > 0.0 ? m_modes[light].vain / misses : 0.0);
  const double saved = hits * hit - misses * probe;
  if (watch.grid.on) {
    watch.grid.saved += saved - rays * kKeysCost;
    watch.grid.searched += searched;
    return;
  }
  watch.cascade.searched += searched;
  watch.cascade.saved += saved - rays * kLookCost;
  if (!watch.cells.on) {
    const double asked = misses / kMissesAsked;
    const double left = since(counts.blocked, before.blocked) - hits;
    watch.cells.searched += searched;
    const double hoped = kCellHits * left * hit - asked * (kCellsCost + kCellMisses * probe);
    watch.hoped_of_cells += hoped;
    watch.hoped_in_all += hoped;
    return;
  }
  const Cascade::GridUse& use = m_cascade.grid_use(light);
  const double in_cells = since(use.hits, before.grid_hits) * hit -
                          since(use.misses, before.grid_misses) * probe;
  const double by_cells = in_cells - since(use.asked, before.grid_asked) * kCellsCost;
  watch.cells.saved += by_cells;
  watch.cells.searched += searched;
  watch.cascade.saved += std::max(by_cells, 0.0) - in_cells;
}

/// True if something else is used from now on. `rays`: so far.
bool AutoTester::decide(Watch& watch, std::uint64_t rays) {
  const SearchSamples& known = watch.known;
  const double set_up = kSetUp * static_cast<double>(m_objects);
  const double by_grid = known.saved_by_grid();
  const bool pays = by_grid > 0.0 && (m_grid || by_grid * static_cast<double>(rays) > 4.0 * set_up);
  const bool steady = known.steady();
  const bool other = watch.grid.decide(pays && known.search() > kDear, steady);
  if (watch.grid.on) return other;
  const bool another = watch.cascade.decide(known.saved_by_neighbourhood() > 0.0, steady);
  if (watch.cascade.on && !another) {
    const bool promising = watch.hoped_of_cells > 0.0;
    const bool in_time = m_cascade.has_cells() || watch.hoped_in_all > set_up;
    watch.hoped_of_cells *= kOlder;
    if (watch.cells.decide(promising && in_time, steady)) watch.hoped_of_cells = 0.0;
  }
  return other || another;
}

}  // namespace lentray::shadow
