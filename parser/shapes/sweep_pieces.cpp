#include "parser/shapes/sweep_pieces.h"

#include <array>
#include <stdexcept>

namespace lentray::parser {
namespace {

/// Of each power of u, the shares of four neighbours.
using Basis = std::array<std::array<double, 4>, 4>;

constexpr Basis kCatmullRom{
    {{0.0, 1.0, 0.0, 0.0}, {-0.5, 0.0, 0.5, 0.0}, {1.0, -2.5, 2.0, -0.5}, {-0.5, 1.5, -1.5, 0.5}}};
constexpr Basis kUniformB{{{1.0 / 6.0, 4.0 / 6.0, 1.0 / 6.0, 0.0},
                           {-0.5, 0.0, 0.5, 0.0},
                           {0.5, -1.0, 0.5, 0.0},
                           {-1.0 / 6.0, 0.5, -0.5, 1.0 / 6.0}}};

core::SweepPiece curved(const SphereSweepShape& sweep, std::size_t first, const Basis& basis) {
  core::SweepPiece piece;
  for (std::size_t power = 0; power < 4; ++power) {
    for (std::size_t k = 0; k < 4; ++k) {
      piece.centre[power] += sweep.centres[first + k] * basis[power][k];
      piece.radius[power] += sweep.radii[first + k] * basis[power][k];
    }
  }
  return piece;
}

}  // namespace

std::vector<core::SweepPiece> sweep_pieces(const SphereSweepShape& sweep) {
  const bool straight = sweep.spline == CurveKind::kLinear;
  const std::size_t reach = straight ? 1 : 3;
  if (sweep.centres.size() <= reach) {
    throw std::runtime_error("a sphere_sweep of this spline needs at least " +
                             std::to_string(reach + 1) + " spheres");
  }
  std::vector<core::SweepPiece> pieces;
  for (std::size_t i = 0; i + reach < sweep.centres.size(); ++i) {
    if (!straight) {
      pieces.push_back(curved(sweep, i, sweep.spline == CurveKind::kB ? kUniformB : kCatmullRom));
      continue;
    }
    core::SweepPiece piece;
    piece.order = 1;
    piece.centre = {sweep.centres[i], sweep.centres[i + 1] - sweep.centres[i]};
    piece.radius = {sweep.radii[i], sweep.radii[i + 1] - sweep.radii[i]};
    pieces.push_back(piece);
  }
  return pieces;
}

}  // namespace lentray::parser
