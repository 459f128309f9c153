#include "core/pattern/pavement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "core/pattern/pavement_walls.h"

namespace lentray::core {
namespace {

std::int64_t wrapped(std::int64_t value, std::int64_t period) {
  const std::int64_t rest = value % period;
  return rest < 0 ? rest + period : rest;
}

/// The walls of a pavement at the nodes of its lattice. A node has as many directions as edges meet
/// there, anticlockwise from the first direction on.
class WallLattice {
 public:
  WallLattice(const PavementWalls& walls, int directions)
      : m_directions(directions), m_shift(walls.shift) {
    for (const char c : std::string_view(walls.rows)) {
      if (c == ' ') {
        ++m_height;
      } else {
        m_nodes.push_back(c - '0');
      }
    }
    m_width = static_cast<int>(m_nodes.size()) / m_height;
  }

  int width() const { return m_width; }
  int height() const { return m_height; }

  /// The node of the period that any node repeats.
  std::size_t index(std::int64_t u, std::int64_t v) const {
    const std::int64_t row = wrapped(v, m_height);
    const std::int64_t below = v / m_height - (v % m_height < 0 ? 1 : 0);
    const std::int64_t periods = wrapped(below, m_width);
    return static_cast<std::size_t>(row * m_width +
                                    wrapped(wrapped(u, m_width) - periods * m_shift, m_width));
  }

  bool wall(int u, int v, int direction) const {
    struct Edge {
      int du, dv, digit;
    };
    static constexpr Edge kSquares[] = {{0, 0, 1}, {0, 0, 2}, {-1, 0, 1}, {0, -1, 2}};
    static constexpr Edge kTriangles[] = {{0, 0, 1},  {0, 0, 2},  {-1, 0, 4},
                                          {-1, 0, 1}, {0, -1, 2}, {0, -1, 4}};
    const int turned = (direction + m_directions) % m_directions;
    const Edge edge = m_directions == 4 ? kSquares[turned] : kTriangles[turned];
    return (m_nodes[index(u + edge.du, v + edge.dv)] & edge.digit) != 0;
  }
  bool any_wall(int u, int v) const {
    for (int i = 0; i < m_directions; ++i) {
      if (wall(u, v, i)) return true;
    }
    return false;
  }

 private:
  int m_directions, m_shift;
  int m_width = 0, m_height = 1;
  std::vector<int> m_nodes;
};

/// What a tile's outline does at a corner of a cell.
enum class Corner : std::uint8_t {
  kPlain,
  kPointed,   ///< both edges of the cell are walls
  kHollow,    ///< neither is, but other cells' walls end here
  kBendNext,  ///< the edge to the next corner is a wall, the neighbour across the other has one too
  kBendPrevious,  ///< the same with the edge to the corner before
};

/// A square or a triangle. Corners are counted anticlockwise; edge i goes from corner i to the next.
template <int Corners>
struct Cell {
  std::array<bool, Corners> walls{};
  std::array<Corner, Corners> corners{};
};

/// A cell's corner: a node and the direction of the edge to the next corner.
struct Place {
  int u, v, direction;
};
constexpr std::array<Place, 4> kSquare = {{{0, 0, 0}, {1, 0, 1}, {1, 1, 2}, {0, 1, 3}}};
constexpr std::array<Place, 3> kLower = {{{0, 0, 0}, {1, 0, 2}, {0, 1, 4}}};
constexpr std::array<Place, 3> kUpper = {{{1, 1, 3}, {0, 1, 5}, {1, 0, 1}}};

template <int Corners>
Cell<Corners> cell_at(const WallLattice& walls, const std::array<Place, Corners>& places, int u,
                      int v) {
  Cell<Corners> cell;
  for (std::size_t i = 0; i < Corners; ++i) {
    const int node_u = u + places[i].u, node_v = v + places[i].v, to_next = places[i].direction;
    const auto wall = [&](int turn) { return walls.wall(node_u, node_v, to_next + turn); };
    const bool next = wall(0), previous = wall(1);
    cell.walls[i] = next;
    if (next && previous) {
      cell.corners[i] = Corner::kPointed;
    } else if (!next && !previous && walls.any_wall(node_u, node_v)) {
      cell.corners[i] = Corner::kHollow;
    } else if (Corners == 3 && next && wall(2)) {
      cell.corners[i] = Corner::kBendNext;
    } else if (Corners == 3 && previous && wall(-1)) {
      cell.corners[i] = Corner::kBendPrevious;
    }
  }
  return cell;
}

/// Polyominoes.
class SquarePavement final : public Pattern {
 public:
  SquarePavement(const Pavement& pavement, const PavementWalls& walls)
      : m_looks(pavement), m_walls(walls, 4) {
    for (int v = 0; v < m_walls.height(); ++v) {
      for (int u = 0; u < m_walls.width(); ++u) {
        m_cells.push_back(cell_at<4>(m_walls, kSquare, u, v));
      }
    }
  }

  double value(const Vec3& p) const override {
    const std::int64_t column = whole_below(p.x), row = whole_below(p.z);
    const double u = 2 * (p.x - static_cast<double>(column));
    const double v = 2 * (p.z - static_cast<double>(row));
    const Cell<4>& cell = m_cells[m_walls.index(column, row)];
    const double from_edge[] = {v, 2 - u, 2 - v, u};
    double value = 0.0;
    for (std::size_t i = 0; i < 4; ++i) {
      const double a = from_edge[i], b = from_edge[(i + 3) % 4];
      if (cell.walls[i]) value = std::max(value, 1 - a);
      if (cell.corners[i] == Corner::kHollow) {
        const bool turn = cell.corners[(i + 2) % 4] == Corner::kPointed;
        if (turn && m_looks.form != 3) return at_turn(a, b);
        value = std::max(value, at_hollow(a, b));
      } else if (cell.corners[i] == Corner::kPointed) {
        value = std::max(value, at_point(a, b));
      }
    }
    return value;
  }

 private:
  /// From here on a and b are twice the distances from the edges that meet at the corner.
  /// A turn's hollow corner.
  double at_turn(double a, double b) const {
    switch (m_looks.form) {
      case 1: return std::min(std::fabs(a + b - 1), 1.0);
      case 2: return std::min(std::fabs(std::hypot(a, b) - 1), 1.0);
      default: return std::max({a - 1, b - 1, std::min(1 - a, 1 - b)});
    }
  }
  double at_hollow(double a, double b) const {
    switch (m_looks.interior) {
      case 1: return 1 - (a + b);
      case 2: return 1 - std::hypot(a, b);
      default: return std::min(1 - a, 1 - b);
    }
  }
  double at_point(double a, double b) const {
    switch (m_looks.exterior) {
      case 1: return std::min(2 - (a + b), 1.0);
      case 2: return a <= 1 && b <= 1 ? std::min(std::hypot(1 - a, 1 - b), 1.0) : 0.0;
      default: return 0.0;
    }
  }

  Pavement m_looks;
  WallLattice m_walls;
  std::vector<Cell<4>> m_cells;
};

/// Polyiamonds and polyhexes: a hexagon is six triangles. A point in a triangle is its weights of the
/// corners: 1 at a corner, 0 on the edge opposite.
class TrianglePavement final : public Pattern {
 public:
  TrianglePavement(const Pavement& pavement, const PavementWalls& walls)
      : m_looks(pavement), m_walls(walls, 6) {
    for (int v = 0; v < m_walls.height(); ++v) {
      for (int u = 0; u < m_walls.width(); ++u) {
        m_lower.push_back(cell_at<3>(m_walls, kLower, u, v));
        m_upper.push_back(cell_at<3>(m_walls, kUpper, u, v));
      }
    }
  }

  double value(const Vec3& p) const override {
    static const double root3 = std::sqrt(3.0);
    const double along = p.x - p.z / root3, up = p.z * 2 / root3;
    const std::int64_t column = whole_below(along), row = whole_below(up);
    const double u = along - static_cast<double>(column), v = up - static_cast<double>(row);
    const std::size_t index = m_walls.index(column, row);
    return u + v > 1 ? in_triangle(m_upper[index], {u + v - 1, 1 - u, 1 - v})
                     : in_triangle(m_lower[index], {1 - u - v, u, v});
  }

 private:
  using Weights = std::array<double, 3>;

  /// The weights' difference from those of another point, as a distance.
  static double length(const Weights& d) {
    return std::sqrt(std::max(0.0, -(d[0] * d[1] + d[1] * d[2] + d[2] * d[0])));
  }
  static double from_corner(Weights w, std::size_t corner) {
    w[corner] -= 1;
    return length(w);
  }

  double in_triangle(const Cell<3>& cell, const Weights& w) const {
    double value = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
      if (cell.walls[i]) value = std::max(value, 1 - 3 * w[(i + 2) % 3]);
      if (cell.corners[i] == Corner::kHollow) value = std::max(value, at_hollow(w, i));
    }
    for (std::size_t i = 0; i < 3; ++i) {
      switch (cell.corners[i]) {
        case Corner::kPointed: value = at_point(w, i, value); break;
        case Corner::kBendNext: value = at_bend(w, i, (i + 2) % 3, value); break;
        case Corner::kBendPrevious: value = at_bend(w, i, (i + 1) % 3, value); break;
        default: break;
      }
    }
    return value;
  }

  /// Above 0 where that corner is the nearest.
  static double nearness(const Weights& w, std::size_t corner) {
    return w[corner] - std::max(w[(corner + 1) % 3], w[(corner + 2) % 3]);
  }
  double at_hollow(const Weights& w, std::size_t corner) const {
    switch (m_looks.interior) {
      case 1: return 1.5 * nearness(w, corner) - 0.5;
      case 2: return 1 - 3 * from_corner(w, corner);
      default: return 3 * w[corner] - 2;
    }
  }
  double at_point(const Weights& w, std::size_t corner, double otherwise) const {
    const double third = 1.0 / 3;
    if (m_looks.exterior == 1) {
      const bool between = std::max(w[(corner + 1) % 3], w[(corner + 2) % 3]) <= third;
      if (between) return std::min(3 * w[corner] - 1, 1.0);
    } else if (m_looks.exterior == 2 && nearness(w, corner) >= 0) {
      const double far = 2 * std::sqrt(3.0) * length({w[0] - third, w[1] - third, w[2] - third});
      return std::min(far, 1.0);
    }
    return otherwise;
  }
  /// The tile has 120 degrees at that corner; `inside` is the corner opposite the wall.
  double at_bend(const Weights& w, std::size_t corner, std::size_t inside, double otherwise) const {
    if (nearness(w, corner) <= 0) return otherwise;
    switch (m_looks.form) {
      case 1: return std::min(2 * (w[corner] - w[inside]), 1.0);
      case 2: return std::clamp(2 * std::sqrt(3.0) * from_corner(w, inside) - 2, 0.0, 1.0);
      default: return otherwise;
    }
  }

  Pavement m_looks;
  WallLattice m_walls;
  std::vector<Cell<3>> m_lower, m_upper;
};

}  // namespace

int pavement_patterns(int sides, int tiles) {
  return static_cast<int>(pavement_walls(sides, tiles).size());
}

PatternPtr make_pavement(const Pavement& pavement) {
  const auto all = pavement_walls(pavement.sides, pavement.tiles);
  if (pavement.pattern < 1 || pavement.pattern > static_cast<int>(all.size())) {
    throw std::invalid_argument("no pavement of number " + std::to_string(pavement.pattern));
  }
  const PavementWalls& walls = all[static_cast<std::size_t>(pavement.pattern - 1)];
  Pavement looks = pavement;
  const auto among = [](int number, int count) {
    return static_cast<std::uint8_t>(number) % count;
  };
  looks.exterior = among(pavement.exterior, 3);
  looks.interior = among(pavement.interior, 3);
  looks.form = among(pavement.form, pavement.sides == 4 ? 4 : 3);
  if (pavement.sides == 4) return std::make_unique<SquarePavement>(looks, walls);
  return std::make_unique<TrianglePavement>(looks, walls);
}

}  // namespace lentray::core
