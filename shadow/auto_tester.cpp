#include "shadow/auto_tester.h"

#include <algorithm>

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

}  // namespace

void AutoTester::Samples::grow_old() {
  for (double* sum : {&count, &searched, &blocked, &searched_blocked, &tests}) *sum *= kOlder;
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
      m_alone(m_watches.size(), kFirstPeriod - kBurst) {
  m_own.by_type = false;
  for (Watch& watch : m_watches) watch.cells.least = kToFill;
  for (std::size_t i = 0; i < m_alone.size(); ++i) {
    if (context.scene->light_buffer(i)) m_alone[i] = kForever;
  }
}

core::Visibility AutoTester::watched(const core::ShadowQuery& query) {
  if (m_plain.context().scene->light_buffer(query.light)) [[unlikely]] {
    m_alone[query.light] = kForever;
    return visibility(query);
  }
  Watch& watch = m_watches[query.light];
  if (watch.left == 0) [[unlikely]] {
    next_part(query.light, watch);
    if (m_alone[query.light] > 0) return visibility(query);
  }
  --watch.left;
  core::ShadowCounts& counts = m_plain.context().counters->lights[query.light];
  ++counts.rays;
  if (watch.part == Part::kSamples) [[unlikely]] return sampled(query, watch, counts);
  ++counts.cached;
  if (watch.part == Part::kGrid) return visibility_by(*m_grid, query, m_plain, counts);
  return visibility_by(m_cascade, query, m_plain, counts);
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
  if (watch.grid.on) {
    m_grid->searched(query, {}, seen.blocker);
  } else if (watch.cascade.on) {
    m_cascade.searched(query, m_cascade.spot(query), seen.blocker);
  }
  return seen;
}

void AutoTester::next_part(std::uint32_t light, Watch& watch) {
  if (watch.part != Part::kSamples) {
    watch.part = Part::kSamples;
    watch.left = kBurst;
    return;
  }
  end_period(light, watch);
  const std::uint32_t others = watch.period - kBurst;
  if (watch.cached()) {
    watch.part = watch.grid.on ? Part::kGrid : Part::kCascade;
    watch.left = others;
  } else {
    m_alone[light] = others;  // and then the samples
    watch.left = kBurst;
  }
}

void AutoTester::end_period(std::uint32_t light, Watch& watch) {
  if (watch.cached()) count(light, watch);
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
  m_cascade.grid_use(light).on = watch.cells.on;
  if (watch.grid.on && !m_grid) m_grid.emplace(*m_plain.context().scene);
  const core::ShadowCounts& counts = m_plain.context().counters->lights[light];
  const Cascade::GridUse& use = m_cascade.grid_use(light);
  watch.before = {counts.hits, counts.misses, use.asked, use.hits, use.misses};
}

/// What the caches saved in the period.
void AutoTester::count(std::uint32_t light, Watch& watch) {
  const core::ShadowCounts& counts = m_plain.context().counters->lights[light];
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
