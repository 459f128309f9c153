#include "shadow/auto_tester.h"

#include <algorithm>
#include <limits>

#include "core/scene/scene.h"

namespace lentray::shadow {
namespace {

// In units of core/accel/test_cost.h.
constexpr double kSearch = 16.0;  ///< beside the tests of a search
constexpr double kProbe = 16.0;   ///< asking an object by itself, beside its test
constexpr double kLook = 6.0;     ///< into an empty neighbourhood
constexpr double kCells = 45.0;   ///< into the cascade's cells
constexpr double kKeys = 70.0;    ///< into those of `grid`, for every ray
constexpr double kDear = 4000.0;  ///< a search beside which no cache's own cost matters
/// Hits and probes in vain that a cache is trusted to make, of blocked rays.
constexpr double kHits = 0.7, kMisses = 0.6;
constexpr double kWorthIt = 0.02;  ///< what must so be saved, a part of the searches
constexpr double kAtALoss = 0.01;  ///< what a cache may cost before it is given up
/// Of the searches so far, for each object: the grid asks them all where they are when it begins.
constexpr double kBeforeCells = 800.0;
constexpr std::uint32_t kToFill = 8;  ///< periods; an empty grid has no hits
constexpr double kOlder = 0.875;   ///< what counts of the period before
constexpr double kSamplesCost = 4e5;  ///< of searches in a period: beside that samples are little

constexpr std::uint64_t kForever = std::numeric_limits<std::uint64_t>::max();

}  // namespace

void AutoTester::Samples::grow_old() {
  for (double* sum : {&count, &searched, &blocked, &searched_blocked, &tests, &pairs, &repeats, &changes}) {
    *sum *= kOlder;
  }
}

double AutoTester::Samples::search() const {
  return kSearch + (count > 0.0 ? searched / count : 0.0);
}

double AutoTester::Samples::hit() const {
  return blocked > 0.0 ? kSearch + (searched_blocked - tests) / blocked - kProbe : 0.0;
}

double AutoTester::Samples::miss() const {
  return kProbe + (blocked > 0.0 ? tests / blocked : 0.0);
}

bool AutoTester::Choice::decide(bool promising) {
  ++periods;
  const bool other = on ? periods >= least && saved <= -kAtALoss * searched
                        : periods >= wait && promising;
  if (other) {
    if (on) wait *= 4;
    on = !on;
    periods = 0;
    saved = searched = 0.0;
  }
  saved *= kOlder;
  searched *= kOlder;
  return other;
}

AutoTester::AutoTester(const core::ShadowContext& context)
    : m_plain(context, true), m_measures(context.count_tests ? context.counters : &m_own),
      m_cascade(*context.scene), m_objects(context.scene->objects().size()),
      m_watches(context.scene->lights().size()),
      m_modes(m_watches.size()) {
  m_own.by_type = false;
  for (Watch& watch : m_watches) watch.cells.least = kToFill;
  for (std::size_t i = 0; i < m_modes.size(); ++i) {
    if (context.scene->light_buffer(i)) m_modes[i].until = kForever;
  }
}

/// Where a part ends: the next one's first ray. Of samples every one.
core::Visibility AutoTester::watched(const core::ShadowQuery& query, core::ShadowCounts& counts) {
  Watch& watch = m_watches[query.light];
  Mode& mode = m_modes[query.light];
  if (watch.in_burst == kBurst) {
    watch.in_burst = 0;
    end_period(query.light, watch, counts);
    mode = {counts.rays + watch.period - kBurst, part_of(watch)};
    return visibility(query);
  }
  ++counts.rays;
  return sampled(query, watch, counts);
}

AutoTester::Part AutoTester::part_of(const Watch& watch) {
  if (watch.grid.on) return Part::kGrid;
  if (!watch.cascade.on) return Part::kPlain;
  return watch.cells.on ? Part::kCascade : Part::kAround;
}

core::Visibility AutoTester::cached(const core::ShadowQuery& query, Part part,
                                    core::ShadowCounts& counts) {
  ++counts.rays;
  ++counts.cached;
  if (part == Part::kAround) return visibility_by(m_cascade.around(), query, m_plain, counts);
  if (part == Part::kCascade) return visibility_by(m_cascade, query, m_plain, counts);
  return visibility_by(*m_grid, query, m_plain, counts);
}

core::Visibility AutoTester::sampled(const core::ShadowQuery& query, Watch& watch,
                                     core::ShadowCounts& counts) {
  ++counts.measured;
  const double before = m_measures->test_cost;
  const core::Visibility seen = m_plain.search(query, m_measures);
  const double search = m_measures->test_cost - before;
  watch.samples.count += 1.0;
  watch.samples.searched += search;
  if (seen.blocker) {
    ++counts.blocked;
    watch.samples.blocked += 1.0;
    watch.samples.searched_blocked += search;
    watch.samples.tests += seen.blocker->test_cost();
  }
  compare(watch, {query.tree_place, seen.blocker});
  if (watch.grid.on) {
    m_grid->searched(query, {}, seen.blocker);
  } else if (watch.cells.on) {
    m_cascade.searched(query, m_cascade.spot(query), seen.blocker);
  } else if (watch.cascade.on) {
    m_cascade.around().searched(query, m_cascade.spot(query), seen.blocker);
  }
  return seen;
}

/// With what came last at its place.
void AutoTester::compare(Watch& watch, const Sample& sample) {
  const auto end = watch.burst.rend();
  const auto before = std::find_if(end - watch.in_burst, end, [&](const Sample& other) {
    return other.place == sample.place;
  });
  watch.burst[watch.in_burst++] = sample;
  if (before == end) return;
  watch.samples.pairs += 1.0;
  if (!before->blocker) return;
  (before->blocker == sample.blocker ? watch.samples.repeats : watch.samples.changes) += 1.0;
}

void AutoTester::end_period(std::uint32_t light, Watch& watch, const core::ShadowCounts& counts) {
  if (watch.cached()) count(light, watch, counts);
  const bool was_cached = watch.cached();
  if (decide(watch)) {
    watch.period = 4 * kFirstPeriod;
  } else if (watch.cascade.periods >= 4 || watch.grid.on) {
    const double most = std::min(kSamplesCost / watch.samples.search(),
                                 1.0 * (was_cached ? kMostCached : kMostPeriod));
    watch.period = std::min(2 * watch.period, static_cast<std::uint32_t>(
                                                  std::max(most, 4.0 * kFirstPeriod)));
  }
  watch.samples.grow_old();
  if (watch.grid.on && !m_grid) m_grid.emplace(*m_plain.context().scene);
  const Cascade::GridUse& use = m_cascade.grid_use(light);
  watch.before = {counts.hits, counts.misses, use.asked, use.hits, use.misses};
}

/// What the caches saved in the period.
void AutoTester::count(std::uint32_t light, Watch& watch, const core::ShadowCounts& counts) {
  const auto since = [](std::uint64_t now, std::uint64_t then) {
    return static_cast<double>(now - then);
  };
  const double hit = watch.samples.hit(), miss = watch.samples.miss();
  const double rays = watch.period - kBurst, searched = rays * watch.samples.search();
  watch.searched += searched;
  const double saved = since(counts.hits, watch.before.hits) * hit -
                       since(counts.misses, watch.before.misses) * miss;
  if (watch.grid.on) {
    watch.grid.saved += saved - rays * kKeys;
    watch.grid.searched += searched;
    return;
  }
  const Cascade::GridUse& use = m_cascade.grid_use(light);
  const double in_cells = since(use.hits, watch.before.grid_hits) * hit -
                          since(use.misses, watch.before.grid_misses) * miss;
  const double by_cells = in_cells - since(use.asked, watch.before.grid_asked) * kCells;
  watch.cells.saved += by_cells;
  watch.cells.searched += searched;
  watch.cascade.saved += saved - in_cells + std::max(by_cells, 0.0) - rays * kLook;
  watch.cascade.searched += searched;
}

/// True if something else is used from now on.
bool AutoTester::decide(Watch& watch) {
  const Samples& samples = watch.samples;
  const double blocked = samples.count > 0.0 ? samples.blocked / samples.count : 0.0;
  const double hoped = blocked * (kHits * samples.hit() - kMisses * samples.miss()) - kLook;
  const bool promising = hoped > kWorthIt * samples.search();
  const bool dear = samples.search() > kDear;
  const bool other = watch.grid.decide(promising && dear);
  if (watch.grid.on) return other;
  const bool another = watch.cascade.decide(promising);
  if (watch.cascade.on && !another) {
    watch.cells.decide(watch.searched > kBeforeCells * static_cast<double>(m_objects));
  }
  return other || another;
}

}  // namespace lentray::shadow
