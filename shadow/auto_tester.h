// Shadow_Cache=auto: for each light the cache that costs least, or none.
//
// A light with a light buffer needs none: what blocks is nearly always the first object of the cell that
// is asked, and counts as a hit then. For the others it is counted on the way: nothing, the
// neighbourhood, the cascade (the neighbourhood, then a grid), or `grid` alone where a search is very dear.
//
// Such a light's rays come in periods; the last few of each are samples (SearchSamples), searched for
// whatever a cache would have answered. While a light goes without a cache, they tell whether
// the neighbourhood would save something, and then it is used. From then on what it does is
// counted ray by ray: hits, each worth the search of a blocked sample, and probes in vain; the same
// for what the grid adds to the neighbourhood. Each stays as long as it costs next to nothing, and
// is tried again when twice as many periods have passed. Periods grow until samples are little
// beside searches. Objects solved by iteration are left alone: counts tell too little of their tests.
// Decisions rest on counts, never on times: one thread decides the same in every run.
// The picture is the plain tester's, as with every cache. One a thread; threads decide apart.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/render/plain_shadow_tester.h"
#include "shadow/cached_tester.h"
#include "shadow/cascade.h"
#include "shadow/search_samples.h"

namespace lentray::shadow {

class AutoTester final : public core::ShadowTester {
 public:
  static constexpr std::string_view kName = "auto";
  explicit AutoTester(const core::ShadowContext& context);
  core::Visibility visibility(const core::ShadowQuery& query) override {
    if (--m_alone[query.light] >= 0) return m_plain.visibility(query);
    return attended(query);
  }

 private:
  // Costs as in core/accel/test_cost.h. What is older counts less and less.

  /// Something that may be used, and what it has saved of what would have been searched.
  struct Choice {
    bool on = false;
    std::uint32_t periods = 0;  ///< since it was taken or given up
    std::uint32_t wait = 2;     ///< so many before it is taken
    std::uint32_t least = 2;    ///< so many before it is given up, unless the loss is large
    double saved = 0.0, searched = 0.0;
    /// After a period. True if it was taken or given up.
    bool decide(bool promising, bool steady);
  };
  /// Of a light's counts when the period began.
  struct Before {
    std::uint64_t blocked = 0, hits = 0, misses = 0, grid_asked = 0, grid_hits = 0, grid_misses = 0;
  };
  /// Caches, before the samples of a period.
  enum class Part : std::uint8_t { kAround, kCascade, kGrid };
  /// What a light with a cache is at. Nothing else is looked at while it goes on.
  struct Mode {
    std::uint64_t until = 0;  ///< rays of the light, all together
    Part part = Part::kAround;
    double vain = 0.0;  ///< tests of probes in vain
  };
  /// What is known of a light.
  struct Watch {
    std::uint32_t period = 0;   ///< rays, with the samples
    std::uint32_t samples = 0;  ///< of this period
    std::uint32_t taken = 0;
    SearchSamples known;
    Choice cascade, cells, grid;  ///< cells: of the cascade; grid: alone
    /// What cells would have saved while the neighbourhood was alone: of late, and in all.
    double hoped_of_cells = 0.0, hoped_in_all = 0.0;
    Before before;
    bool cached() const { return cascade.on || grid.on; }
  };

  [[gnu::noinline]] core::Visibility attended(const core::ShadowQuery& query);
  [[gnu::noinline]] core::Visibility watched(const core::ShadowQuery& query,
                                             core::ShadowCounts& counts);
  core::Visibility sampled(const core::ShadowQuery& query, Watch& watch,
                           core::ShadowCounts& counts);
  void remember(const core::ShadowQuery& query, const Watch& watch, const core::Object* blocker);
  void begin_period(std::uint32_t light, Watch& watch, const core::ShadowCounts& counts);
  void count(std::uint32_t light, Watch& watch, const core::ShadowCounts& counts);
  bool decide(Watch& watch, std::uint64_t rays);

  core::PlainShadowTester m_plain;
  core::Counters m_own;        ///< of samples, where nobody else counts
  core::Counters* const m_counting;  ///< the run's, or null
  core::Counters* const m_measures;  ///< the run's, or those
  Cascade m_cascade;
  std::optional<CacheTable<DirectionPolicy>> m_grid;  ///< none before it is used
  const std::size_t m_objects;                        ///< of the scene
  std::vector<Watch> m_watches;                       ///< one a light
  std::vector<Mode> m_modes;                          ///< the same
  std::vector<std::int64_t> m_alone;  ///< the same: so many rays to come that are just searched for
};

}  // namespace lentray::shadow
