#include "shadow/auto_tester.h"

#include <algorithm>
#include <cmath>

#include "core/scene/scene.h"
#include "shadow/cached_tester.h"

namespace lentray::shadow {
namespace {

// In units of core/accel/test_cost.h.
constexpr double kProbe = 16.0;  ///< asking an object by itself, beside its test
constexpr std::array<double, 3> kKeys{5.0, 15.0, 70.0};  ///< tree, neighbourhood, grid
constexpr double kDear = 4000.0;  ///< a search beside which no cache's own cost matters
/// What a cache must promise to save, a part of the searches' cost.
constexpr double kWorthATrial = 0.10, kWorthIt = 0.03;
constexpr double kAtALoss = 0.01;     ///< what a cache may cost where nothing is blocked
constexpr double kRarely = 20.0;      ///< trials of a light that has its cache
constexpr double kSamplesCost = 4e5;  ///< of searches in a period: beside that samples are little

}  // namespace

AutoTester::AutoTester(const core::ShadowContext& context)
    : m_plain(context), m_measures(context.count_tests ? context.counters : &m_own),
      m_tree(TreePolicy(*context.scene)), m_neighbourhood(NeighbourhoodPolicy(*context.scene)),
      m_watches(context.scene->lights().size()) {
  m_own.by_type = false;
}

core::Visibility AutoTester::watched(const core::ShadowQuery& query, Watch& watch) {
  if (watch.left == 0) next_part(watch);
  --watch.left;
  core::ShadowCounts& counts = m_plain.context().counters->lights[query.light];
  ++counts.rays;
  if (watch.sampling) {
    ++counts.measured;
    const core::Visibility seen = sampled(query, watch);
    if (seen.blocker) ++counts.blocked;
    return seen;
  }
  ++counts.cached;
  if (watch.mode == Mode::kTree) return visibility_by(m_tree, query, m_plain, counts);
  if (watch.mode == Mode::kGrid) return visibility_by(*m_grid, query, m_plain, counts);
  return visibility_by(m_neighbourhood, query, m_plain, counts);
}

core::Visibility AutoTester::sampled(const core::ShadowQuery& query, Watch& watch) {
  const double before = m_measures->test_cost;
  const core::Visibility seen = m_plain.search(query, m_measures);
  const double search = m_measures->test_cost - before;
  watch.searched += search;
  if (watch.mode != Mode::kOff) {
    watch.saved += search - cost(query, watch.mode, seen.blocker, search);
  } else if (seen.blocker) {
    watch.saved += std::max(0.0, search - kKeys[0] - kProbe - seen.blocker->test_cost());
  }
  return seen;
}

/// With a cache. `blocker`: what the search found for `search`.
double AutoTester::cost(const core::ShadowQuery& query, Mode mode, const core::Object* blocker,
                        double search) {
  const double keys = kKeys[static_cast<std::size_t>(mode)];
  if (mode == Mode::kTree) return keys + cost_with(m_tree, query, blocker, search);
  if (mode == Mode::kGrid) return keys + cost_with(*m_grid, query, blocker, search);
  return keys + cost_with(m_neighbourhood, query, blocker, search);
}

template <class Policy>
double AutoTester::cost_with(CacheTable<Policy>& table, const core::ShadowQuery& query,
                             const core::Object* blocker, double search) {
  double probes = 0.0;
  const bool hit = table.probe(query, [&](const core::Object& entry) {
    probes += kProbe + entry.test_cost();
    // Where the search finds nothing no entry does.
    return blocker && (&entry == blocker || m_plain.blocks(entry, query));
  });
  if (blocker && !hit) table.remember(query, blocker);
  return hit ? probes : probes + search;
}

void AutoTester::next_part(Watch& watch) {
  const std::uint32_t burst = watch.trial ? kTrialBurst : kBurst;
  if (!watch.sampling) {
    watch.sampling = true;
    watch.left = burst;
    return;
  }
  ++watch.bursts;
  const bool dear = !watch.distrusted && watch.searched > kDear * watch.bursts * kBurst;
  if (watch.mode == Mode::kOff && dear && watch.saved > kWorthATrial * watch.searched) {
    start(watch, Mode::kGrid, false, kLeastPeriod);
  } else if (watch.bursts == kBursts) {
    end_region(watch);
  }
  const std::uint32_t others = watch.period - (watch.trial ? kTrialBurst : kBurst);
  if (watch.mode == Mode::kOff) {
    watch.alone = others;  // and then the samples
    watch.left = kBurst;
  } else {
    watch.sampling = false;
    watch.left = others;
  }
}

void AutoTester::end_region(Watch& watch) {
  const double samples = kBursts * (watch.trial ? kTrialBurst : kBurst);
  const double mean = std::max(1.0, watch.searched / samples);
  const double saved = watch.saved / (mean * samples);
  watch.since_trial += mean * kBursts * watch.period;
  if (watch.trial) {
    watch.trials[static_cast<std::size_t>(watch.mode)] = saved;
    end_trial(watch);
    return;
  }
  const double longest = std::clamp(kSamplesCost / mean, 1.0 * kLeastPeriod, 1.0 * kMostPeriod);
  const std::uint32_t longer = std::min(2 * watch.period, static_cast<std::uint32_t>(longest));
  const bool off = watch.mode == Mode::kOff;
  const bool of_use = saved > (off ? kWorthATrial : 0.0);
  if (!off && mean > kDear && !watch.distrusted && saved > -kAtALoss) {
    start(watch, Mode::kGrid, false, std::min(2 * watch.period, kMostPeriod));
  } else if (!of_use) {
    watch.distrusted = watch.distrusted || (!off && mean > kDear);
    start(watch, Mode::kOff, false, longer);
  } else if (watch.since_trial >= watch.next_trial) {
    start(watch, Mode::kTree, true, kLeastPeriod);
  } else {
    start(watch, off ? watch.best : watch.mode, false, longer);
  }
}

void AutoTester::end_trial(Watch& watch) {
  const std::size_t next = static_cast<std::size_t>(watch.mode) + 1;
  if (next < kCaches) {
    start(watch, static_cast<Mode>(next), true, kLeastPeriod);
    return;
  }
  const auto best = std::max_element(watch.trials.begin(), watch.trials.end());
  const bool pays = *best >= kWorthIt;
  watch.best = pays ? static_cast<Mode>(best - watch.trials.begin()) : Mode::kOff;
  watch.next_trial = pays ? kRarely * kBeforeTrial : 2.0 * watch.next_trial;
  watch.since_trial = 0.0;
  start(watch, watch.best, false, kLeastPeriod);
}

void AutoTester::start(Watch& watch, Mode mode, bool trial, std::uint32_t period) {
  if (mode == Mode::kGrid && !m_grid) m_grid.emplace(DirectionPolicy(*m_plain.context().scene));
  watch.mode = mode;
  watch.trial = trial;
  watch.period = period;
  watch.bursts = 0;
  watch.searched = watch.saved = 0.0;
}

}  // namespace lentray::shadow
