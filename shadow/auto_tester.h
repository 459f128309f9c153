// Shadow_Cache=auto: for each light the cache that costs least, or none, as counted on the way.
//
// A light's rays come in regions of kBursts periods; at the end of each period a few rays are
// samples: their searches are counted (tests, weighted by what they cost), whatever a cache would
// have answered. While a light goes without a cache, samples tell what one that is always right
// would save. If that is worth a trial, and so much was searched that a trial is little beside it,
// each cache runs for a region, and samples tell what it saved; the best stays, unless none saves
// enough. From then on it is used in regions where something can be saved; trials come again, but
// rarely. Where a search is very dear, the cache with the most hits is taken at once. Periods grow
// until samples are little beside searches.
// Decisions rest on counts, never on times: one thread decides the same in every run.
// The picture is the plain tester's, as with every cache. One a thread; threads decide apart.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/render/plain_shadow_tester.h"
#include "shadow/cache_table.h"
#include "shadow/direction_policy.h"

namespace lentray::shadow {

class AutoTester final : public core::ShadowTester {
 public:
  static constexpr std::string_view kName = "auto";
  explicit AutoTester(const core::ShadowContext& context);
  core::Visibility visibility(const core::ShadowQuery& query) override {
    Watch& watch = m_watches[query.light];
    if (watch.alone == 0) return watched(query, watch);
    --watch.alone;
    return m_plain.visibility(query);
  }

  static constexpr std::uint32_t kBursts = 8, kBurst = 8;  ///< periods a region, samples a period
  static constexpr std::uint32_t kTrialBurst = 24;
  static constexpr std::uint32_t kLeastPeriod = 256, kMostPeriod = 1u << 14;  ///< rays of a light

 private:
  static constexpr double kBeforeTrial = 1e7;  ///< some thirty times what a trial may cost

  enum class Mode : std::uint8_t { kTree, kNeighbourhood, kGrid, kOff };
  static constexpr std::size_t kCaches = 3;

  /// What a light is at, and what its samples have counted; costs as in core/accel/test_cost.h.
  struct Watch {
    std::uint32_t alone = kLeastPeriod - kBurst;  ///< rays to come that need no attention
    std::uint32_t left = kBurst;                  ///< others of this part of the period
    Mode mode = Mode::kOff;
    bool sampling = true;  ///< those are samples
    bool trial = false;    ///< of `mode`
    bool distrusted = false;  ///< the cache taken without a trial cost more than it saved
    std::uint32_t period = kLeastPeriod;
    std::uint32_t bursts = 0;          ///< of this region
    double searched = 0.0;             ///< by searches alone
    double saved = 0.0;                ///< by the cache, or by one that is always right
    Mode best = Mode::kOff;            ///< of the last trial
    double since_trial = 0.0;          ///< spent on searches, about
    double next_trial = kBeforeTrial;  ///< comes when so much is spent
    std::array<double, kCaches> trials{};  ///< what caches saved, parts of 1
  };

  core::Visibility watched(const core::ShadowQuery& query, Watch& watch);
  void next_part(Watch& watch);
  void end_region(Watch& watch);
  void end_trial(Watch& watch);
  void start(Watch& watch, Mode mode, bool trial, std::uint32_t period);
  core::Visibility sampled(const core::ShadowQuery& query, Watch& watch);
  double cost(const core::ShadowQuery& query, Mode mode, const core::Object* blocker,
              double search);
  template <class Policy>
  double cost_with(CacheTable<Policy>& table, const core::ShadowQuery& query,
                   const core::Object* blocker, double search);

  core::PlainShadowTester m_plain;
  core::Counters m_own;        ///< of samples, where nobody else counts
  core::Counters* m_measures;  ///< that, or the run's
  CacheTable<TreePolicy> m_tree;
  CacheTable<NeighbourhoodPolicy> m_neighbourhood;
  std::optional<CacheTable<DirectionPolicy>> m_grid;  ///< none before it is used
  std::vector<Watch> m_watches;  ///< one a light
};

}  // namespace lentray::shadow
