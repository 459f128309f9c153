#include "core/pattern/tile_lattice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace lentray::core {
namespace {

constexpr int kCells = 8;
/// Flat middles above level 0 lie a trace above their level. A colour map with a step at the
/// level shows it.
constexpr double kTrace = 1e-6;
/// What counts as on an edge: without it, rounding would mix both tiles' values on a wall that stands
/// on their edge.
constexpr double kEdgeWidth = 1e-9;

PlanePoint operator+(PlanePoint a, PlanePoint b) { return {a.x + b.x, a.z + b.z}; }
PlanePoint operator-(PlanePoint a, PlanePoint b) { return {a.x - b.x, a.z - b.z}; }
PlanePoint operator*(PlanePoint a, double f) { return {a.x * f, a.z * f}; }
double cross(PlanePoint a, PlanePoint b) { return a.x * b.z - a.z * b.x; }

/// 0 on the edge, 1 where its bevel ends, below 0 outside.
struct Edge {
  double x, z, constant;
  double depth(PlanePoint p) const { return x * p.x + z * p.z + constant; }
};

/// A tile at one place.
struct Piece {
  std::vector<Edge> edges;
  int level;
};

double area(const Tile& tile) {
  double twice = 0.0;
  for (std::size_t i = 0; i < tile.corners.size(); ++i) {
    twice += cross(tile.corners[i], tile.corners[(i + 1) % tile.corners.size()]);
  }
  return twice / 2.0;
}

Piece piece_of(const Tile& tile, PlanePoint shift, double bevel) {
  Piece piece{{}, tile.level};
  const double sense = area(tile) < 0.0 ? -1.0 : 1.0;
  for (std::size_t i = 0; i < tile.corners.size(); ++i) {
    const PlanePoint from = tile.corners[i] + shift;
    const PlanePoint along = tile.corners[(i + 1) % tile.corners.size()] + shift - from;
    const double width = tile.bevels.empty() ? bevel : tile.bevels[i];
    const double scale = sense / (std::hypot(along.x, along.z) * width);
    const PlanePoint inwards{-along.z * scale, along.x * scale};
    piece.edges.push_back({inwards.x, inwards.z, -(inwards.x * from.x + inwards.z * from.z)});
  }
  return piece;
}

/// False only where an edge has all the corners outside.
bool may_meet(const Piece& piece, const std::array<PlanePoint, 4>& corners) {
  constexpr double kMargin = 1e-6;
  return std::none_of(piece.edges.begin(), piece.edges.end(), [&](const Edge& edge) {
    return std::all_of(corners.begin(), corners.end(),
                       [&](PlanePoint corner) { return edge.depth(corner) < -kMargin; });
  });
}

class TileLattice final : public Pattern {
 public:
  explicit TileLattice(const TilePlan& plan)
      : m_first(plan.first_step), m_second(plan.second_step), m_part(1.0 / plan.levels),
        m_lean(plan.edges_by_order ? 0.0 : kEdgeWidth),
        m_slack(plan.edges_by_order ? kEdgeWidth : 0.0) {
    const double determinant = cross(m_first, m_second);
    m_to_first = {m_second.z / determinant, -m_second.x / determinant};
    m_to_second = {-m_first.z / determinant, m_first.x / determinant};
    const std::vector<Piece> pieces = all_pieces(plan);
    std::vector<Candidate> candidates;
    for (const Piece& piece : pieces) {
      candidates.push_back(
          {static_cast<int>(m_edges.size()), static_cast<int>(piece.edges.size()), piece.level});
      m_edges.insert(m_edges.end(), piece.edges.begin(), piece.edges.end());
    }
    for (int second = 0; second < kCells; ++second) {
      for (int first = 0; first < kCells; ++first) add_cell(pieces, candidates, first, second);
    }
    m_starts.push_back(static_cast<int>(m_candidates.size()));
  }

  double value(const Vec3& point) const override {
    const PlanePoint p{point.x + m_lean, point.z + m_lean};
    const double first = m_to_first.x * p.x + m_to_first.z * p.z;
    const double second = m_to_second.x * p.x + m_to_second.z * p.z;
    const auto first_step = static_cast<double>(whole_below(first));
    const auto second_step = static_cast<double>(whole_below(second));
    const PlanePoint rest = p - m_first * first_step - m_second * second_step;
    const int cell = cell_of(second - second_step) * kCells + cell_of(first - first_step);
    double depth = -std::numeric_limits<double>::infinity();
    int level = 0;
    for (int i = m_starts[cell]; i < m_starts[cell + 1] && depth < -m_slack; ++i) {
      const double here = depth_in(m_candidates[i], rest);
      // Rounding can leave a point at an edge outside all tiles: the one it is nearest to counts.
      if (here <= depth) continue;
      depth = here;
      level = m_candidates[i].level;
    }
    const double rise = std::clamp(1.0 - depth, level > 0 ? kTrace : 0.0, 1.0);
    return (level + rise) * m_part;
  }

 private:
  /// A range of m_edges.
  struct Candidate {
    int first_edge, edge_count, level;
  };

  /// All that reach into the parallelogram, at each of their places.
  std::vector<Piece> all_pieces(const TilePlan& plan) const {
    constexpr int kReach = 3;
    const std::array<PlanePoint, 4> corners = {PlanePoint{}, m_first, m_first + m_second, m_second};
    std::vector<Piece> pieces;
    for (const Tile& tile : plan.tiles) {
      for (int i = -kReach; i <= kReach; ++i) {
        for (int k = -kReach; k <= kReach; ++k) {
          Piece piece = piece_of(tile, m_first * i + m_second * k, plan.bevel);
          if (may_meet(piece, corners)) pieces.push_back(std::move(piece));
        }
      }
    }
    return pieces;
  }

  void add_cell(const std::vector<Piece>& pieces, const std::vector<Candidate>& candidates,
                int first, int second) {
    constexpr double kStep = 1.0 / kCells;
    const PlanePoint origin = m_first * (first * kStep) + m_second * (second * kStep);
    const PlanePoint along = m_first * kStep, up = m_second * kStep;
    m_starts.push_back(static_cast<int>(m_candidates.size()));
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      if (may_meet(pieces[i], {origin, origin + along, origin + along + up, origin + up})) {
        m_candidates.push_back(candidates[i]);
      }
    }
  }

  double depth_in(const Candidate& candidate, PlanePoint p) const {
    const Edge* edge = &m_edges[candidate.first_edge];
    double depth = edge->depth(p);
    for (int i = 1; i < candidate.edge_count; ++i) depth = std::min(depth, edge[i].depth(p));
    return depth;
  }

  /// Of what lies from 0 on and below 1; anything else may come of coordinates that are no numbers.
  static int cell_of(double part) {
    const double cell = part * kCells;
    return cell >= 0.0 && cell < kCells ? static_cast<int>(cell) : 0;
  }

  PlanePoint m_first, m_second;        ///< the sides of the parallelogram
  PlanePoint m_to_first, m_to_second;  ///< from a point to how many of them
  double m_part;                       ///< of 0..1, for a level
  double m_lean;                       ///< of points, towards the tile that has the edge
  double m_slack;                      ///< a tile's reach beyond its edges
  std::vector<int> m_starts;           ///< of each cell's candidates, and their end
  std::vector<Candidate> m_candidates;
  std::vector<Edge> m_edges;
};

}  // namespace

PatternPtr make_tile_lattice(const TilePlan& plan) { return std::make_unique<TileLattice>(plan); }

}  // namespace lentray::core
