// A uniform grid over boxes: each cell lists the boxes that lie in it, a ray is walked from cell
// to cell. Kept for comparison with the hierarchy; scenes of very different sizes are its weakness.
// Space: the boxes' own. Immutable once built; any number of threads.
//
// Conservative: boxes are entered into all cells within kPad of a cell's size about them, which is
// more than rounding moves a ray that starts no further than kFar times the grid's size away; other
// rays are told all boxes.
// Source: Fujimoto, Tanaka and Iwata, "ARTS: Accelerated Ray-Tracing System", 1986; Amanatides and
// Woo, "A Fast Voxel Traversal Algorithm for Ray Tracing", 1987.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/bounds.h"
#include "core/base/ray.h"

namespace lentray::core {

class UniformGrid {
 public:
  UniformGrid() = default;
  /// Boxes must be finite; empty ones are left out.
  explicit UniformGrid(std::span<const Bounds> boxes);

  bool empty() const { return m_first.empty(); }
  std::size_t cells() const { return m_first.empty() ? 0 : m_first.size() - 1; }
  std::size_t entries() const { return m_parts.size(); }
  std::size_t memory() const;

  /// Calls cell(parts) with the numbers of the boxes in each cell that the ray passes from t = 0
  /// on, near cells first, until that returns true or the cell left ends beyond limit(). A box may
  /// come in several cells. `limit` is asked again after each cell.
  template <class Limit, class Cell>
  void walk(const Ray& ray, Limit&& limit, Cell&& cell) const;

 private:
  static constexpr double kPad = 1e-6;
  static constexpr double kFar = 1e6;
  static constexpr double kLeastComponent = 1e-30;  ///< of the direction's largest; less is none

  /// A ray on its way: per axis the cell, the step, and where the cell is left.
  struct Walker {
    std::array<int, 3> at{}, step{};
    std::array<double, 3> inverse{}, leaves{};
  };
  enum class Start : std::uint8_t { kMisses, kInside, kTooFar };
  Start start(const Ray& ray, double limit, Walker& walker) const;
  double border(const Ray& ray, const Walker& walker, int axis) const {
    if (walker.step[axis] == 0) return Bounds::kInf;
    const int side = walker.at[axis] + (walker.step[axis] > 0 ? 1 : 0);
    return (m_box.lo[axis] + side * m_size[axis] - ray.origin[axis]) * walker.inverse[axis];
  }
  std::size_t index(const std::array<int, 3>& at) const {
    return (static_cast<std::size_t>(at[2]) * m_cells[1] + at[1]) * m_cells[0] + at[0];
  }
  std::array<int, 3> cell_of(const Vec3& p) const;
  std::span<const std::uint32_t> in_cell(std::size_t cell) const {
    return {m_parts.data() + m_first[cell], m_first[cell + 1] - m_first[cell]};
  }

  Bounds m_box;
  Vec3 m_size;  ///< of a cell
  std::array<int, 3> m_cells{};
  std::vector<std::uint32_t> m_first;  ///< of a cell in m_parts; one more at the end
  std::vector<std::uint32_t> m_parts;
  std::vector<std::uint32_t> m_all;  ///< every part, for rays from too far away
};

template <class Limit, class Cell>
void UniformGrid::walk(const Ray& ray, Limit&& limit, Cell&& cell) const {
  if (empty()) return;
  Walker walker;
  switch (start(ray, limit(), walker)) {
    case Start::kMisses: return;
    case Start::kTooFar: cell(std::span<const std::uint32_t>(m_all)); return;
    case Start::kInside: break;
  }
  for (;;) {
    if (cell(in_cell(index(walker.at)))) return;
    const std::array<double, 3>& t = walker.leaves;
    const int axis = t[0] < t[1] ? (t[0] < t[2] ? 0 : 2) : (t[1] < t[2] ? 1 : 2);
    if (!(t[axis] <= limit())) return;
    walker.at[axis] += walker.step[axis];
    if (walker.at[axis] < 0 || walker.at[axis] >= m_cells[axis]) return;
    walker.leaves[axis] = border(ray, walker, axis);
  }
}

}  // namespace lentray::core
