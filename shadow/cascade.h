// The cache `cascade`: what blocked around the point in the picture, and where that does not block
// any longer, what blocked near its direction as the light sees it. Where it was light all around
// nothing is tried, so that light parts cost hardly more than without a cache. The grid learns
// what the neighbourhood did not know: where shadows begin.
#pragma once

#include <optional>

#include "shadow/cache_table.h"
#include "shadow/direction_policy.h"
#include "shadow/neighbourhood.h"

namespace lentray::shadow {

class Cascade {
 public:
  static constexpr std::string_view kName = "cascade";
  explicit Cascade(const core::Scene& scene) : m_scene(scene), m_around(scene) {}

  using Spot = Neighbourhood::Spot;
  Spot spot(const core::ShadowQuery& query) { return m_around.spot(query); }
  static bool empty(const Spot& spot) { return Neighbourhood::empty(spot); }
  template <class Ask>
  const core::Object* probe(const core::ShadowQuery& query, const Spot& spot, Tried& tried,
                            Ask&& ask) {
    if (const core::Object* entry = m_around.probe(query, spot, tried, ask)) return entry;
    find_cells(query);
    return probe_cells(tried, ask);
  }
  void found(const core::ShadowQuery& query, const Spot& spot, const core::Object* blocker) {
    m_around.found(query, spot, blocker);
    if (m_cells_known) remember(blocker);
    m_cells_known = false;
  }
  void searched(const core::ShadowQuery& query, const Spot& spot, const core::Object* blocker) {
    m_around.searched(query, spot, blocker);
    if (blocker) {
      if (!m_cells_known) find_cells(query);
      remember(blocker);
    }
    m_cells_known = false;
  }

 private:
  template <class Ask>
  const core::Object* probe_cells(Tried& tried, Ask&& ask) {
    return ask_in_turn([&](std::size_t i) { return m_entries[m_cells[i]]; }, m_cells.size(), tried,
                       tried.count() + m_cells.size(), ask);
  }
  [[gnu::noinline]] void find_cells(const core::ShadowQuery& query) {
    if (!m_grid) {
      m_grid.emplace(m_scene);  // reads all objects
      m_entries = zeroed_entries(m_grid->slots());
    }
    m_cells = m_grid->cells(query);
    m_cells_known = true;
  }
  void remember(const core::Object* blocker) {
    for (const std::size_t cell : m_cells) m_entries[cell] = blocker;
  }

  const core::Scene& m_scene;
  Neighbourhood m_around;
  std::optional<DirectionPolicy> m_grid;  ///< none before it is used
  Entries m_entries;
  Keys<3> m_cells{};           ///< of this query
  bool m_cells_known = false;  ///< it asked the grid
};

}  // namespace lentray::shadow
