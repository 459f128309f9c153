// The cache `neighbourhood`: what blocked around the point in the picture, at the same place in the
// ray tree: the last point of its column and the last one of its row, in most orders the pixels
// above and to the left, and the last of the next column and row. Points that nothing blocked empty
// their slots: where it is light no object is tried, and little more is done than without a cache.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

#include "shadow/cache_table.h"

namespace lentray::shadow {

class Neighbourhood {
 public:
  static constexpr std::string_view kName = "neighbourhood";
  static constexpr std::size_t kProbes = 2;
  explicit Neighbourhood(const core::Scene& scene)
      : m_blocks(scene.lights().size() * core::kTreePlaces) {}

  /// The slots of a point; those of the next column and row lie behind them.
  struct Spot {
    const core::Object** column;
    const core::Object** row;
  };
  Spot spot(const core::ShadowQuery& query) {
    Entries& block = m_blocks[query.light * core::kTreePlaces + query.tree_place];
    if (!block) [[unlikely]] block = zeroed_entries(2 * kEach);
    return {block.get() + query.column % kSide, block.get() + kEach + query.row % kSide};
  }
  static bool empty(const Spot& spot) {
    return !spot.column[0] && !spot.row[0] && !spot.row[1] && !spot.column[1];
  }
  template <class Ask>
  const core::Object* probe(const core::ShadowQuery&, const Spot& spot, Tried& tried, Ask&& ask) {
    const std::array entries{spot.column[0], spot.row[0], spot.row[1], spot.column[1]};
    return ask_in_turn([&](std::size_t i) { return entries[i]; }, entries.size(), tried, kProbes,
                       ask);
  }
  void found(const core::ShadowQuery& query, const Spot& spot, const core::Object* blocker) {
    searched(query, spot, blocker);
  }
  void searched(const core::ShadowQuery&, const Spot& spot, const core::Object* blocker) {
    *spot.column = *spot.row = blocker;
  }

 private:
  static constexpr std::size_t kSide = 4096;  ///< larger pictures wrap around
  static constexpr std::size_t kEach = kSide + 1;
  std::vector<Entries> m_blocks;  ///< for each light and place; null until used
};

}  // namespace lentray::shadow
