// Shadow_Cache=auto: for each light the cache that costs least, or none.
//
// A light with a light buffer needs none: what blocks is nearly always the first object of the cell that
// is asked, and counts as a hit then. For the others it is counted on the way: nothing, the
// neighbourhood, the cascade (the neighbourhood, then a grid), or `grid` alone where a search is very dear.
//
// Such a light's rays come in periods, at the end of which is decided. The last few rays of a period are
// samples (SearchSamples), searched for whatever a cache would have answered. While a light goes
// without a cache, they and the rays that are blocked tell what the neighbourhood would save; once
// that is more than a trial may cost, it is used. From then on what it does is
// counted ray by ray: hits, each worth the search of a blocked sample, and probes in vain; the same
// for what the grid adds to the neighbourhood. Each stays as long as it costs next to nothing; what its
// trials lost it must promise twice before the next. Without a cache samples are left out where
// little is blocked, and may cost a small share of the searches; with one, periods grow.
// Objects solved by iteration are left alone: counts tell too little of their tests.
// Decisions rest on counts, never on times: one thread decides the same in every run.
// The picture is the plain tester's, as with every cache. One a thread; threads decide apart.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/trace/plain_shadow_tester.h"
#include "shadow/cached_tester.h"
#include "shadow/cascade.h"
#include "shadow/search_samples.h"

namespace lentray::shadow {

class AutoTester final : public core::ShadowTester {
 public:
  static constexpr std::string_view kName = "auto";
  explicit AutoTester(core::ThreadContext& context);
  core::Visibility visibility(const core::ShadowQuery& query) override {
    Turn& turn = m_turns[query.light];
    if (--turn.left < 0) [[unlikely]] return watched(query, turn);
    if (turn.ask) return turn.ask(*this, query, *turn.counts);
    return searched(query, *turn.counts);
  }

 private:
  // Costs as in core/accel/test_cost.h. What is older counts less and less.

  /// Something that may be used. It is taken when it promises more than twice what it lost before,
  /// and given up when it lost more than a trial may.
  struct Choice {
    bool on = false;
    double hoped = 0.0;  ///< while it is off: what it would have saved since it last promised nothing
    double lost = 0.0;   ///< by all its trials; what it saved in others was taken off
    double saved = 0.0, searched = 0.0;  ///< while it is on, of late: of what would have been searched
    double in_all = 0.0;                 ///< while it is on: saved
    /// After a period without it, which it would have saved so much of. True if it was taken.
    bool take(double hope, bool steady);
    /// After a period with it. True if it was given up. `trial`: what it may lose at first.
    bool give_up(double trial, bool steady);
    void add(double saved_now, double searched_now);
  };
  /// Of a light's counts when the period began.
  struct Before {
    std::uint64_t rays = 0, blocked = 0, hits = 0, misses = 0;
    std::uint64_t grid_asked = 0, grid_hits = 0, grid_misses = 0;
  };
  /// What is known of a light.
  struct Watch {
    std::uint32_t period = 0;   ///< rays, with the samples
    std::uint32_t samples = 0;  ///< of this period
    std::uint32_t taken = 0;
    bool promising = true;  ///< enough is blocked for a cache
    double searched = 0.0, sampled = 0.0;  ///< in all: what searches cost, and samples on top
    SearchSamples known;
    Choice cascade, cells, grid;  ///< cells: of the cascade; grid: alone
    double hope_of_cells = 0.0;  ///< what they would have saved in the period
    Before before;
    bool cached() const { return cascade.on || grid.on; }
  };

  core::Visibility searched(const core::ShadowQuery& query, core::ShadowCounts& counts) {
    ++counts.rays;
    const core::Visibility seen = m_plain.search(query);
    if (seen.blocker) ++counts.blocked;
    return seen;
  }
  /// Asks a cache.
  using Ask = core::Visibility (*)(AutoTester& self, const core::ShadowQuery& query,
                                   core::ShadowCounts& counts);
  /// What comes next of a light: so many rays that ask a cache, or are just searched for (null). Then
  /// samples.
  struct Turn {
    std::int64_t left = 0;
    Ask ask = nullptr;
    core::ShadowCounts* counts = nullptr;
  };
  template <class AnAsker>
  [[gnu::always_inline]] static core::Visibility ask(const core::ShadowQuery& query,
                                                     core::ShadowCounts& counts,
                                                     AnAsker& asker) {
    ++counts.rays;
    ++counts.cached;
    return asker.visibility(query, counts);
  }
  static core::Visibility ask_around(AutoTester& self, const core::ShadowQuery& query,
                                     core::ShadowCounts& counts) {
    return ask(query, counts, self.m_ask_around);
  }
  static core::Visibility ask_cascade(AutoTester& self, const core::ShadowQuery& query,
                                      core::ShadowCounts& counts) {
    return ask(query, counts, self.m_ask_cascade);
  }
  static core::Visibility ask_grid(AutoTester& self, const core::ShadowQuery& query,
                                   core::ShadowCounts& counts) {
    return ask(query, counts, *self.m_ask_grid);
  }
  static Ask asked_by(const Watch& watch) {
    if (watch.grid.on) return ask_grid;
    if (watch.cells.on) return ask_cascade;
    return watch.cascade.on ? ask_around : nullptr;
  }
  [[gnu::noinline]] core::Visibility watched(const core::ShadowQuery& query, Turn& turn);
  core::Visibility sampled(const core::ShadowQuery& query, Watch& watch,
                           core::ShadowCounts& counts);
  void remember(const core::ShadowQuery& query, const Watch& watch, const core::Object* blocker);
  void begin_period(std::uint32_t light, Watch& watch, Turn& turn);
  void count(std::uint32_t light, Watch& watch, const core::ShadowCounts& counts);
  bool decide(Watch& watch, const core::ShadowCounts& counts);
  double hoped_of_cells() const;
  std::uint32_t next_period(const Watch& watch, bool other) const;

  core::PlainShadowTester m_plain;
  core::Counters m_own;        ///< of samples, where nobody else counts
  core::Counters* const m_counting;  ///< the run's, or null
  core::Counters* const m_measures;  ///< the run's, or those
  Cascade m_cascade;
  std::optional<CacheTable<DirectionPolicy>> m_grid;  ///< none before it is used
  std::vector<double> m_vain;                         ///< probes in vain of this period, one a light
  Asker<Neighbourhood, true> m_ask_around;
  Asker<Cascade, true> m_ask_cascade;
  std::optional<Asker<CacheTable<DirectionPolicy>, true>> m_ask_grid;
  const std::size_t m_objects;                        ///< of the scene
  std::vector<Watch> m_watches;                       ///< one a light
  std::vector<Turn> m_turns;                          ///< the same
};

}  // namespace lentray::shadow
