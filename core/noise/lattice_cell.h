// A cell of the lattice that noise is made on, read from the tables: plain code, and what the faster
// ways of noise are held against.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/noise/lattice.h"
#include "core/noise/noise_table.h"

namespace lentray::core {

inline constexpr int kLattice = 4096;
/// 0..4095 shuffled, twice in a row so that index + 1 needs no wrap.
using LatticeHashTable = std::array<std::uint16_t, 2 * kLattice>;
extern const LatticeHashTable kLatticeHash;

/// One axis of a lattice cell: its index, the point's place in it and the two weights.
struct CellAxis {
  int index;
  double near, far;  ///< from the lower and the upper corner
  double weight_near, weight_far;

  explicit CellAxis(double x) {
    const double below = x >= 0.0 ? x : x - (1.0 - kCellEpsilon);
    // Beyond all cells, and for nan, what the processor makes of the conversion.
    const std::int64_t cell = std::fabs(below) < 9e18 ? static_cast<std::int64_t>(below)
                                                      : std::numeric_limits<std::int64_t>::min();
    index = static_cast<int>((cell + kLatticeOrigin) & (kLattice - 1));
    near = x - static_cast<double>(cell);
    far = near - 1.0;
    weight_far = s_curve(near);
    weight_near = 1.0 - weight_far;
  }
};

/// The eight corners of the cell a point lies in, with the gradients' place in the table.
struct LatticeCell {
  CellAxis x, y, z;
  std::array<int, 4> columns;  ///< hashes of (x, y): bit 0 x, bit 1 y

  explicit LatticeCell(const Vec3& p) : x(p.x), y(p.y), z(p.z) {
    for (int i = 0; i < 4; ++i) {
      const int a = kLatticeHash[static_cast<std::size_t>(x.index + (i & 1))];
      columns[static_cast<std::size_t>(i)] =
          kLatticeHash[static_cast<std::size_t>(a ^ (y.index + (i >> 1)))];
    }
  }
  const double* gradient(int column, int layer) const {
    const int hash = columns[static_cast<std::size_t>(column)] ^ (z.index + layer);
    return &kNoiseGradients[kLatticeHash[static_cast<std::size_t>(hash)] & 0xFFu];
  }
};

inline double corner(const double* g, double x, double y, double z) {
  return g[0] * 0.5 + g[1] * x + g[2] * y + g[3] * z;
}

/// Calls `visit(gradient, weight, x, y, z)` for the corners in the order 000, 100, 010, 110, 001 ...
/// Spelled out: as a loop it is not unrolled, and takes half as long again.
template <typename Visit>
inline void for_corners(const LatticeCell& cell, Visit visit) {
  const auto one = [&](int column, int layer) {
    const bool far_x = column & 1, far_y = column & 2;
    const double weight = (far_x ? cell.x.weight_far : cell.x.weight_near) *
                          (far_y ? cell.y.weight_far : cell.y.weight_near) *
                          (layer ? cell.z.weight_far : cell.z.weight_near);
    visit(cell.gradient(column, layer), weight, far_x ? cell.x.far : cell.x.near,
          far_y ? cell.y.far : cell.y.near, layer ? cell.z.far : cell.z.near);
  };
  one(0, 0);
  one(1, 0);
  one(2, 0);
  one(3, 0);
  one(0, 1);
  one(1, 1);
  one(2, 1);
  one(3, 1);
}

}  // namespace lentray::core
