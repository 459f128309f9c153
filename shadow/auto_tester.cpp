#include "shadow/auto_tester.h"

#include <algorithm>
#include <limits>

#include "core/scene/scene.h"
#include "core/trace/thread_context.h"

namespace lentray::shadow {
namespace {

// Rays of a light.
constexpr std::uint32_t kFirst = 32, kLeast = 32, kMost = 256, kMostCached = 1u << 12;
/// Samples in a row, and every how many of them the search is measured (with a cache: all).
constexpr std::uint32_t kRow = 16, kMeasured = 8, kRowCached = 8;

// In units of core/accel/test_cost.h.
constexpr double kDear = 4000.0;  ///< a search beside which no cache's own cost matters
constexpr double kPeriodCost = 3e4;  ///< of searches in a period without a cache
constexpr double kSampleCost = 10.0, kMeasuring = 60.0;  ///< of a sample beside its search
/// For each object: the grid asks them all where they are when it begins.
constexpr double kSetUp = 24.0;

constexpr double kSampling = 0.004;  ///< of searches: what samples may cost where there is no cache
constexpr double kAtALoss = 0.02;    ///< of searches: what a cache may cost before it is given up
constexpr double kUnsure = 0.03;     ///< of searches: what samples must promise besides
constexpr double kTrial = 2000.0;    ///< what a trial may lose besides
constexpr double kRemembered = 1e6;  ///< of searches: what counts of those before
/// Of rays that are blocked and the neighbourhood has no hit for: those that its cells have one for.
/// And probes in vain of those that ask them.
constexpr double kCellHits = 0.6, kCellMisses = 0.6;
constexpr double kMissesAsked = 1.7;  ///< probes of the neighbourhood that sent one on to the cells
constexpr std::int64_t kForever = std::numeric_limits<std::int64_t>::max();

double since(std::uint64_t now, std::uint64_t then) { return static_cast<double>(now - then); }

}  // namespace

bool AutoTester::Choice::take(double hope, bool steady) {
  hoped = std::max(0.0, hoped + hope);
  if (!steady || hoped <= kTrial + 2.0 * lost) return false;
  on = true;
  saved = searched = in_all = 0.0;
  return true;
}

void AutoTester::Choice::add(double saved_now, double searched_now) {
  const double kept = std::min(1.0, kRemembered / (searched + 1.0));
  saved = kept * saved + saved_now;
  searched = kept * searched + searched_now;
  in_all += saved_now;
}

bool AutoTester::Choice::give_up(double trial, bool steady) {
  if (steady && saved > -(kAtALoss * searched + trial)) return false;
  on = false;
  lost = std::max(0.0, lost - in_all);
  hoped = 0.0;
  return true;
}

AutoTester::AutoTester(core::ThreadContext& context)
    : m_plain(context, true), m_counting(context.tests),
      m_measures(m_counting ? m_counting : &m_own),
      m_cascade(context.scene), m_vain(context.scene.lights().size(), 0.0),
      m_ask_around(m_cascade.around(), m_plain, m_vain.data()),
      m_ask_cascade(m_cascade, m_plain, m_vain.data()),
      m_objects(context.scene.objects().size()),
      m_watches(context.scene.lights().size()),
      m_turns(m_watches.size()) {
  m_own.by_type = false;
  for (Watch& watch : m_watches) {
    watch.period = kFirst;
    watch.samples = kRow;
  }
  for (std::size_t i = 0; i < m_turns.size(); ++i) {
    m_turns[i].left = context.scene.light_buffer(i) ? kForever : kFirst - kRow;
    m_turns[i].counts = &context.counters.lights[i];
  }
}

/// The samples, and the first ray of the next period.
core::Visibility AutoTester::watched(const core::ShadowQuery& query, Turn& turn) {
  Watch& watch = m_watches[query.light];
  if (watch.taken == 0) {
    count(query.light, watch, *turn.counts);
    watch.known.begin_row();
  }
  if (watch.taken == watch.samples) {
    begin_period(query.light, watch, turn);
    return visibility(query);  // the first one
  }
  return sampled(query, watch, *turn.counts);
}

core::Visibility AutoTester::sampled(const core::ShadowQuery& query, Watch& watch,
                                     core::ShadowCounts& counts) {
  const bool measured = watch.cached() || watch.taken % kMeasured == 0;
  ++watch.taken;
  ++counts.rays;
  const double cost = m_measures->test_cost;
  const core::Visibility seen = m_plain.search(query, measured ? m_measures : m_counting);
  if (seen.blocker) ++counts.blocked;
  watch.known.add(query.tree_place, seen.blocker);
  watch.sampled += kSampleCost;
  if (measured) {
    ++counts.measured;
    watch.sampled += kMeasuring;
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

void AutoTester::begin_period(std::uint32_t light, Watch& watch, Turn& turn) {
  const core::ShadowCounts& counts = *turn.counts;
  const bool other = decide(watch, counts);
  watch.period = next_period(watch, other);
  if (watch.samples > 0) watch.known.grow_old();
  watch.samples = watch.cached() ? kRowCached : kRow;
  watch.taken = 0;
  turn.left = watch.period - watch.samples;
  turn.ask = asked_by(watch);
  if (watch.grid.on && !m_grid) {
    m_grid.emplace(m_plain.context().scene);
    m_ask_grid.emplace(*m_grid, m_plain, m_vain.data());
  }
  m_vain[light] = 0.0;
  const Cascade::GridUse& use = m_cascade.grid_use(light);
  watch.before = {counts.rays, counts.blocked, counts.hits, counts.misses,
                  use.asked, use.hits, use.misses};
}

/// Without a cache they cost about the same; with one they grow, as nothing is to be found out.
std::uint32_t AutoTester::next_period(const Watch& watch, bool other) const {
  const double cheap = kPeriodCost / watch.known.search();
  const auto shortest = static_cast<std::uint32_t>(std::clamp(cheap, 1.0 * kLeast, 1.0 * kMost));
  if (watch.cached()) {
    const bool losing = !watch.grid.on && watch.cascade.saved < 0.0;
    return other ? shortest : losing ? watch.period : std::min(2 * watch.period, kMostCached);
  }
  return watch.promising ? shortest : std::min(2 * watch.period, 2 * shortest);
}

/// What was searched in the period, and what the caches saved. Without a cache the samples are left out
/// where there is nothing to find out, or where they cost too much already.
void AutoTester::count(std::uint32_t light, Watch& watch, const core::ShadowCounts& counts) {
  const Before& before = watch.before;
  const double rays = since(counts.rays, before.rays), searched = rays * watch.known.search();
  const double blocked = since(counts.blocked, before.blocked);
  watch.searched += searched;
  if (!watch.cached()) {
    watch.known.set_blocked(blocked / rays);
    watch.promising = blocked * watch.known.hit() > rays * kLookCost;
    const bool dear = watch.sampled > kSampling * watch.searched;
    if (watch.known.any() && (!watch.promising || dear)) watch.samples = 0;
    return;
  }
  const double hits = since(counts.hits, before.hits), misses = since(counts.misses, before.misses);
  const double hit = watch.known.hit();
  const double probe = kProbeCost + (misses > 0.0 ? m_vain[light] / misses : 0.0);
  const double saved = hits * hit - misses * probe;
  if (watch.grid.on) {
    watch.grid.add(saved - rays * kKeysCost, searched);
    return;
  }
  if (!watch.cells.on) {
    watch.cascade.add(saved - rays * kLookCost, searched);
    const double asked = misses / kMissesAsked;
    watch.hope_of_cells =
        kCellHits * (blocked - hits) * hit - asked * (kCellsCost + kCellMisses * probe);
    return;
  }
  const Cascade::GridUse& use = m_cascade.grid_use(light);
  const double in_cells = since(use.hits, before.grid_hits) * hit -
                          since(use.misses, before.grid_misses) * probe;
  const double by_cells = in_cells - since(use.asked, before.grid_asked) * kCellsCost;
  watch.cells.add(by_cells, searched);
  watch.cascade.add(saved - rays * kLookCost + std::max(by_cells, 0.0) - in_cells, searched);
}

/// True if something else is used from now on.
bool AutoTester::decide(Watch& watch, const core::ShadowCounts& counts) {
  const SearchSamples& known = watch.known;
  const double rays = since(counts.rays, watch.before.rays);
  const double set_up = kSetUp * static_cast<double>(m_objects);
  const bool steady = known.steady();
  if (watch.grid.on) return watch.grid.give_up(kTrial, steady);
  if (known.search() > kDear) {
    const double hope = rays * known.saved_by_grid();
    if (watch.grid.take(hope, steady && (m_grid || watch.grid.hoped + hope > set_up))) return true;
  }
  if (!watch.cascade.on) {
    const double promise = known.saved_by_neighbourhood() - kUnsure * known.search();
    return watch.cascade.take(rays * promise, steady);
  }
  if (watch.cascade.give_up(kTrial, steady)) return true;
  if (watch.cells.on) return watch.cells.give_up(std::max(kTrial, set_up), steady);
  const double hope = watch.hope_of_cells;
  return watch.cells.take(hope, steady && (m_cascade.has_cells() || hoped_of_cells() + hope > set_up));
}

/// For all lights: one grid is set up for them.
double AutoTester::hoped_of_cells() const {
  double sum = 0.0;
  for (const Watch& watch : m_watches) sum += watch.cells.hoped;
  return sum;
}

}  // namespace lentray::shadow
