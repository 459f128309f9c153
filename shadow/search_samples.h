// What is known of a light's shadow rays from samples, some in a row now and then: what searches cost,
// and what the cache `neighbourhood` would have known. The latter comes cheap: whether the blocker is the
// one before it at the same place of the ray tree. What is older counts less.
// Costs are those of core/accel/test_cost.h. One a light and thread.
#pragma once

#include <array>
#include <cstdint>

#include "core/trace/shadow_tester.h"

namespace lentray::shadow {

// What a cache itself costs.
inline constexpr double kSearchCost = 14.0;  ///< of a search, beside its tests
inline constexpr double kProbeCost = 20.0;   ///< asking an object by itself, beside its test
inline constexpr double kLookCost = 8.0;     ///< a look into the neighbourhood, for every ray
inline constexpr double kCellsCost = 96.0;   ///< into the cascade's cells: most of it is memory to be fetched
inline constexpr double kKeysCost = 50.0;    ///< into those of `grid`, for every ray

class SearchSamples {
 public:
  /// A row of samples begins: the one before the next is far away.
  void begin_row() { m_known = 0; }
  void add(std::uint32_t tree_place, const core::Object* blocker) {
    const std::uint64_t bit = std::uint64_t{1} << tree_place;
    const core::Object* before = m_last[tree_place];
    m_last[tree_place] = blocker;
    if (m_known & bit) {
      m_sums.pairs += 1.0;
      if (before && before == blocker) m_sums.repeats += 1.0;
      if (before && before != blocker) {
        m_sums.changes += 1.0;
        m_sums.vain += before->test_cost();
      }
    }
    m_known |= bit;
  }
  /// Of one of them: what its search cost.
  void add_cost(double search, const core::Object* blocker);
  void grow_old();
  /// Of all rays of late, not the samples alone: the share that was blocked.
  void set_blocked(double share) { m_blocked = share; }

  bool any() const { return m_sums.count > 0.0; }
  double search() const;  ///< mean cost
  double hit() const;     ///< what it saves that a blocked ray is answered at once
  /// What the neighbourhood would save a ray. Less than 0: it would cost so much.
  double saved_by_neighbourhood() const;
  double saved_by_grid() const;  ///< the same of `grid` alone
  /// False where what blocks is so dear that counts say little: objects solved by iteration take next to
  /// nothing or thousands of steps, and most often the latter where they blocked a ray nearby.
  bool steady() const {
    return m_sums.tests + m_sums.vain <= kMostATest * (m_sums.blocked + m_sums.changes);
  }

 private:
  struct Sums {
    double count = 0.0, searched = 0.0;
    double blocked = 0.0, searched_blocked = 0.0, tests = 0.0;  ///< tests: of the blockers alone
    /// With one before them in the row at the same place, and how many of them that one's blocker would
    /// have answered, or not.
    double pairs = 0.0, repeats = 0.0, changes = 0.0;
    double vain = 0.0;  ///< the latter ones' tests
  };
  static constexpr double kMostATest = 400.0;

  Sums m_sums;
  double m_blocked = 0.0;
  std::array<const core::Object*, core::kTreePlaces> m_last{};  ///< blockers in the row, by place
  std::uint64_t m_known = 0;                                   ///< which places had one, or none
  static_assert(core::kTreePlaces <= 64);
};

}  // namespace lentray::shadow
