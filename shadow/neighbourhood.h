// The cache `neighbourhood`: what blocked around the point in the picture, at the same place in the
// ray tree: the last point of its column and the last one of its row, in most orders the pixels
// above and to the left, and the last of the next column and row. Points that nothing blocked empty
// their slots: where it is light no object is tried, and little more is done than without a cache.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "shadow/cache_table.h"

namespace lentray::shadow {

class Neighbourhood {
 public:
  static constexpr std::string_view kName = "neighbourhood";
  explicit Neighbourhood(const core::Scene& scene) : Neighbourhood(scene.lights().size()) {}
  /// For the first so many lights.
  explicit Neighbourhood(std::size_t lights) : m_blocks(lights * core::kTreePlaces) {}

  /// The slots of a point; those of the next column and row lie behind them. Null before anything was
  /// blocked at its place in the ray tree.
  struct Spot {
    const core::Object** column;
    const core::Object** row;
  };
  Spot spot(const core::ShadowQuery& query) const {
    const core::Object** const block = m_blocks[number(query)].get();
    return block ? within(block, query) : Spot{};
  }
  static bool empty(const Spot& spot) {
    return !spot.column || (!spot.column[0] && !spot.row[0] && !spot.row[1] && !spot.column[1]);
  }
  /// Two of them, the nearest first. Written out: this is asked for most rays.
  template <class Ask>
  const core::Object* probe(const core::ShadowQuery&, const Spot& spot, Tried& tried, Ask&& ask) {
    const core::Object* const above = spot.column[0];
    const core::Object* const left = spot.row[0];
    const core::Object* const below = spot.row[1];
    const core::Object* const right = spot.column[1];
    const core::Object* const first = above ? above : left ? left : below ? below : right;
    if (!first) return nullptr;
    if (ask(*first)) return first;
    tried.add(first);
    const auto other = [first](const core::Object* entry) { return entry && entry != first; };
    const core::Object* const second = other(left)    ? left
                                       : other(below) ? below
                                       : other(right) ? right
                                                      : nullptr;
    if (!second) return nullptr;
    if (ask(*second)) return second;
    tried.add(second);
    return nullptr;
  }
  void found(const core::ShadowQuery& query, const Spot& spot, const core::Object* blocker) {
    searched(query, spot, blocker);
  }
  void searched(const core::ShadowQuery& query, Spot spot, const core::Object* blocker) {
    if (!spot.column) [[unlikely]] {
      if (!blocker) return;
      spot = first_spot(query);
    }
    *spot.column = *spot.row = blocker;
  }

 private:
  static constexpr std::size_t kSide = 4096;  ///< larger pictures wrap around
  static constexpr std::size_t kEach = kSide + 1;
  static std::size_t number(const core::ShadowQuery& query) {
    return query.light * core::kTreePlaces + query.tree_place;
  }
  static Spot within(const core::Object** block, const core::ShadowQuery& query) {
    return {block + query.column % kSide, block + kEach + query.row % kSide};
  }
  [[gnu::noinline]] Spot first_spot(const core::ShadowQuery& query) {
    Entries& block = m_blocks[number(query)];
    block = zeroed_entries(2 * kEach);
    return within(block.get(), query);
  }

  std::vector<Entries> m_blocks;  ///< for each light and place; null until used
};

}  // namespace lentray::shadow
