#include "core/shape/bicubic_patch.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace lentray::core {
namespace {

/// Bernstein polynomials of order 3 and their derivatives.
struct Weights {
  std::array<double, 4> value, slope;
  explicit Weights(double s) {
    const double r = 1.0 - s;
    value = {r * r * r, 3.0 * s * r * r, 3.0 * s * s * r, s * s * s};
    slope = {-3.0 * r * r, 3.0 * r * (r - 2.0 * s), 3.0 * s * (2.0 * r - s), 3.0 * s * s};
  }
};

/// Along both together: a net of more pieces would need more memory than a picture shows.
constexpr int kMostPatchHalvings = 18;

/// For slopes that lie in a line. Source: stock's.
constexpr double kFlat = 1e-10;

/// Where the slopes give none it is the x axis.
Vec3 corner_normal(const Vec3& by_u, const Vec3& by_v) {
  const Vec3 n = cross(by_u, by_v);
  const bool known = length_squared(n) > kFlat * length_squared(by_u) * length_squared(by_v);
  return known ? normalized(n) : Vec3{1, 0, 0};
}

/// A piece of the patch by control points of its own; its edges counted in steps of the finest net.
struct Piece {
  std::array<Vec3, 16> points;
  std::uint32_t row, last_row, column, last_column;
};

/// The two halves of the curve through four points `stride` apart, in place and in `upper`.
void halve_curve(std::array<Vec3, 16>& points, std::array<Vec3, 16>& upper, std::size_t first,
                 std::size_t stride) {
  const auto between = [](const Vec3& a, const Vec3& b) { return (a + b) * 0.5; };
  const std::size_t at[4] = {first, first + stride, first + 2 * stride, first + 3 * stride};
  const Vec3 middle = between(points[at[1]], points[at[2]]);
  upper[at[3]] = points[at[3]];
  upper[at[2]] = between(points[at[2]], points[at[3]]);
  upper[at[1]] = between(middle, upper[at[2]]);
  points[at[1]] = between(points[at[0]], points[at[1]]);
  points[at[2]] = between(points[at[1]], middle);
  points[at[3]] = upper[at[0]] = between(points[at[2]], upper[at[1]]);
}

/// `lower` becomes the half of small u (or v), the other half is returned.
Piece halve(Piece& lower, bool by_u) {
  Piece upper = lower;
  for (std::size_t i = 0; i < 4; ++i) {
    halve_curve(lower.points, upper.points, by_u ? i : 4 * i, by_u ? 4 : 1);
  }
  if (by_u) {
    lower.last_row = upper.row = (lower.row + lower.last_row) / 2;
  } else {
    lower.last_column = upper.column = (lower.column + lower.last_column) / 2;
  }
  return upper;
}

/// Whether all control points are nearer than `flatness` to the plane of three of the corners.
bool is_flat(const std::array<Vec3, 16>& points, double flatness) {
  constexpr double kSamePoint = 1e-20;  // squared
  if (!(flatness > 0.0)) return false;
  const Vec3 &a = points[0], &c = points[12];
  const Vec3& b = length_squared(points[3] - a) < kSamePoint ? points[15] : points[3];
  const Vec3 n = cross(a - b, c - b);
  const double size = length_squared(n);
  if (!(size > kFlat * length_squared(a - b) * length_squared(c - b))) return false;
  const double most = flatness * std::sqrt(size);
  return std::all_of(points.begin(), points.end(),
                     [&](const Vec3& p) { return std::fabs(dot(p - a, n)) < most; });
}

}  // namespace

/// Collects the corners and triangles of the pieces.
class BicubicPatch::NetMaker {
 public:
  NetMaker(const BicubicPatch& patch, std::uint32_t rows, std::uint32_t columns)
      : m_patch(&patch), m_rows(rows), m_columns(columns),
        m_corners(std::size_t{rows + 1} * (columns + 1), kNoIndex) {}

  void add(Piece piece) {
    const bool by_u = piece.last_row - piece.row > 1, by_v = piece.last_column - piece.column > 1;
    if (is_flat(piece.points, m_patch->m_flatness) || !(by_u || by_v)) {
      add_triangles(piece);
      return;
    }
    const auto add_halves = [&](Piece& lower) {
      if (by_v) add(halve(lower, false));
      add(lower);
    };
    if (by_u) {
      Piece upper = halve(piece, true);
      add_halves(upper);
    }
    add_halves(piece);
  }

  MeshData take() { return std::move(m_data); }

 private:
  void add_triangles(const Piece& piece) {
    const std::uint32_t a = corner(piece.row, piece.column),
                        b = corner(piece.row, piece.last_column);
    const std::uint32_t c = corner(piece.last_row, piece.last_column);
    const std::uint32_t d = corner(piece.last_row, piece.column);
    for (const MeshTriple& corners : {MeshTriple{a, b, c}, MeshTriple{a, c, d}}) {
      m_data.faces.push_back(corners);
      m_data.face_normals.list.push_back(corners);
      m_data.face_uvs.list.push_back(corners);
    }
  }

  std::uint32_t corner(std::uint32_t row, std::uint32_t column) {
    std::uint32_t& known = m_corners[std::size_t{row} * (m_columns + 1) + column];
    if (known == kNoIndex) {
      known = static_cast<std::uint32_t>(m_data.vertices.size());
      const double u = static_cast<double>(row) / m_rows,
                   v = static_cast<double>(column) / m_columns;
      Vec3 place, by_u, by_v;
      m_patch->evaluate(u, v, place, by_u, by_v);
      m_data.vertices.push_back(place);
      m_data.normals.push_back(corner_normal(by_u, by_v));
      m_data.uvs.push_back({u, v});
    }
    return known;
  }

  const BicubicPatch* m_patch;
  std::uint32_t m_rows, m_columns;
  std::vector<std::uint32_t> m_corners;  ///< numbers of those met, else kNoIndex
  MeshData m_data;
};

BicubicPatch::BicubicPatch(const std::array<Vec3, 16>& points, int u_steps, int v_steps,
                           double flatness, const Corners& corners)
    : m_points(points), m_u_steps(u_steps), m_v_steps(v_steps), m_flatness(flatness),
      m_corners(corners) {
  constexpr int kMostSteps = 16;
  int by_u = std::clamp(u_steps, 0, kMostSteps), by_v = std::clamp(v_steps, 0, kMostSteps);
  while (by_u + by_v > kMostPatchHalvings) --(by_u > by_v ? by_u : by_v);
  const auto rows = std::uint32_t{1} << by_u, columns = std::uint32_t{1} << by_v;
  NetMaker maker(*this, rows, columns);
  maker.add({points, 0, rows, 0, columns});
  m_net = std::make_unique<Mesh>(std::make_shared<const TriangleMesh>(maker.take()), std::nullopt,
                                 true);
}

std::unique_ptr<Shape> BicubicPatch::baked(const Transform& t) const {
  std::array<Vec3, 16> moved = m_points;
  for (Vec3& p : moved) p = t.point(p);
  return std::make_unique<BicubicPatch>(moved, m_u_steps, m_v_steps, m_flatness, m_corners);
}

void BicubicPatch::evaluate(double u, double v, Vec3& place, Vec3& by_u, Vec3& by_v) const {
  const Weights across(u), along(v);
  place = by_u = by_v = Vec3{};
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      const Vec3& p = m_points[4 * i + j];
      place += p * (across.value[i] * along.value[j]);
      by_u += p * (across.slope[i] * along.value[j]);
      by_v += p * (across.value[i] * along.slope[j]);
    }
  }
}

Vec2 BicubicPatch::uv(const Vec3& p, const ShapeHit& hit) const {
  const Vec2 at = m_net->uv(p, hit);
  const double u = at.v, v = at.u;  // along a row, and from row to row
  const double weights[] = {(1.0 - u) * (1.0 - v), u * (1.0 - v), u * v, (1.0 - u) * v};
  Vec2 out;
  for (std::size_t i = 0; i < 4; ++i) {
    out.u += weights[i] * m_corners[i].u;
    out.v += weights[i] * m_corners[i].v;
  }
  return out;
}

}  // namespace lentray::core
