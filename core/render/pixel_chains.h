// Chains of pixels: those of a tile that join one another, each to its neighbour on the left and to the one above.
// In an ordinary picture a tile is one chain; behind a lens sheet each view is one.
//
// A chain is followed row by row, from the left, where each pixel depends on what its left and upper neighbours have
// become. Pixels of different rows do not depend on one another if each row is some places behind the one above:
// these are visited at one step. Pixels of the image. Plain values.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/render/pixel_lattice.h"

namespace lentray::core {

struct PixelChain {
  static constexpr std::uint32_t kOutside = ~0u;

  std::vector<std::uint32_t> columns;  ///< ascending
  /// By place in `columns`: the place of the left neighbour, or kOutside.
  std::vector<std::uint32_t> left;
  /// A place, and the column of its neighbour on the right, which is outside. Visited after all places, once a row.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> ahead;
  /// So many places a row is behind the one above it, at least.
  std::size_t lag = 1;

  /// Places of a row, those ahead included.
  std::size_t visits() const { return columns.size() + ahead.size(); }
  std::size_t steps(std::size_t rows) const { return rows == 0 ? 0 : visits() + lag * (rows - 1); }
  /// What is visited at a step of a chain of so many rows, in any order: `visit(place, row)`.
  template <class Visit>
  void at_step(std::size_t step, std::size_t rows, const Visit& visit) const {
    const std::size_t first = step < visits() ? 0 : (step - visits()) / lag + 1;
    const std::size_t end = std::min(rows, step / lag + 1);
    for (std::size_t row = first; row < end; ++row) visit(step - lag * row, row);
  }
};

/// Of the tile of the columns [begin, end).
std::vector<PixelChain> chains_of_tile(const PixelLattice& lattice, std::uint32_t begin,
                                       std::uint32_t end);

}  // namespace lentray::core
