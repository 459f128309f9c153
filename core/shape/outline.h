// A flat region bounded by closed curves of line, quadratic and cubic pieces: what text and prisms
// sweep through space. Plane coordinates (u, v); even-odd rule.
// Robust at vertices: a point belongs to a line's one side or the other, never to both, and pieces
// share their end points, so a line meets the boundary an even number of times.
// Immutable; any number of threads.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/base/vec3.h"
#include "core/numeric/plane_boxes.h"

namespace lentray::core {

/// ((a s + b) s + c) s + d for s in 0..1. `end` is the point at s = 1, the start of the next piece.
struct CurvePiece {
  Vec2 a, b, c, d;
  Vec2 end;
  Vec2 at(double s) const {
    return {((a.u * s + b.u) * s + c.u) * s + d.u, ((a.v * s + b.v) * s + c.v) * s + d.v};
  }
  bool is_straight() const { return a.u == 0.0 && a.v == 0.0 && b.u == 0.0 && b.v == 0.0; }
  /// Derivative by s.
  Vec2 slope(double s) const;
  /// The most that direction.u u + direction.v v becomes.
  double farthest(const Vec2& direction) const;

  static CurvePiece line(const Vec2& from, const Vec2& to);
  static CurvePiece conic(const Vec2& from, const Vec2& control, const Vec2& to);
  static CurvePiece bezier(const Vec2& from, const Vec2& control1, const Vec2& control2,
                           const Vec2& to);
};

class Outline {
  static constexpr double kInf = std::numeric_limits<double>::infinity();

 public:
  /// The pieces of all curves; each curve's last piece ends where its first begins.
  explicit Outline(std::vector<CurvePiece> pieces);

  bool contains(double u, double v) const;
  /// What is known of a place without counting.
  enum class Place : std::uint8_t { kOutside, kInside, kUnsure };
  Place place(double u, double v) const;
  /// The most that direction.u u + direction.v v becomes.
  double farthest(const Vec2& direction) const;
  /// Calls visit(piece, s, point), until that answers false, where the line a u + b v + c = 0 crosses the
  /// boundary; off the way, which follows it, it may leave crossings out.
  template <class Visit>
  void crossings(double a, double b, double c, const PlaneWay& way, Visit&& visit) const;
  /// The same for who looks for the first along a known way: visit() answers whether a crossing counts;
  /// those certainly beyond one that does may be left out. Any order.
  template <class Visit>
  void first_crossings(double a, double b, double c, const PlaneWay& way, Visit&& visit) const;
  /// Whether it is one convex polygon.
  bool is_convex() const;
  const std::vector<CurvePiece>& pieces() const { return m_pieces; }
  const Vec2& lo() const { return m_lo; }
  const Vec2& hi() const { return m_hi; }

 private:
  friend struct PlainShapes;  // tests/unit/shape/plain_shapes.h
  static PlaneBox box_of(const CurvePiece& piece);
  void fill_squares();
  void fill_row(int row);
  void mark(const CurvePiece& piece, const PlaneBox& box);
  void mark_line(const Vec2& from, const Vec2& to);
  void mark(int row, double u, double other_u);
  bool contains_counted(double u, double v) const;
  /// Whether the line across at v crosses the boundary an odd number of times in from < u <= to.
  bool is_odd(double v, double from, double to) const;
  /// Which column or row a place is in, beyond them the nearest.
  int column_of(double u) const { return square_of((u - m_lo.u) * m_columns_per_u); }
  int row_of(double v) const { return square_of((v - m_lo.v) * m_rows_per_v); }
  Vec2 in_squares(const Vec2& p) const {
    return {(p.u - m_lo.u) * m_columns_per_u, (p.v - m_lo.v) * m_rows_per_v};
  }
  int square_of(double at) const {
    return at > 0.0 ? static_cast<int>(std::min(at, static_cast<double>(m_side - 1))) : 0;
  }

  std::vector<CurvePiece> m_pieces;
  std::vector<PlaneBox> m_boxes;
  PlaneBoxes m_search;  ///< of the same
  Vec2 m_lo, m_hi;
  /// Squares over lo() .. hi(), a bit each: those that a piece may come into, and of the others those
  /// inside.
  static constexpr int kMostSquares = 32;
  int m_side = 1;
  double m_columns_per_u = 0.0, m_rows_per_v = 0.0;
  std::array<std::uint32_t, kMostSquares> m_mixed{}, m_inside{};
};

/// Parameters in 0..1 at which the piece crosses the line, at most three; the number of them.
int line_crossings(const CurvePiece& piece, double a, double b, double c, double s[3]);

inline Outline::Place Outline::place(double u, double v) const {
  if (!(u >= m_lo.u && u <= m_hi.u && v >= m_lo.v && v <= m_hi.v)) return Place::kOutside;
  const auto row = static_cast<std::size_t>(row_of(v));
  const int column = column_of(u);
  if ((m_mixed[row] >> column & 1u) != 0) return Place::kUnsure;
  return (m_inside[row] >> column & 1u) != 0 ? Place::kInside : Place::kOutside;
}

inline bool Outline::contains(double u, double v) const {
  const Place at = place(u, v);
  return at == Place::kUnsure ? contains_counted(u, v) : at == Place::kInside;
}

template <class Visit>
void Outline::crossings(double a, double b, double c, const PlaneWay& way, Visit&& visit) const {
  m_search.along(way, [&](std::size_t i) {
    double s[3];
    const int n = line_crossings(m_pieces[i], a, b, c, s);
    for (int k = 0; k < n; ++k) {
      if (!visit(static_cast<std::uint32_t>(i), s[k], m_pieces[i].at(s[k]))) return false;
    }
    return true;
  });
}

/// By where their boxes begin, along the axis that the way is longer on.
template <class Visit>
void Outline::first_crossings(double a, double b, double c, const PlaneWay& way,
                              Visit&& visit) const {
  constexpr double kSlack = 1e-6;
  constexpr int kMost = 16;
  struct Candidate {
    double begin;
    std::size_t piece;
  };
  Candidate waiting[kMost];
  int count = 0;
  const double du = way.end.u - way.begin.u, dv = way.end.v - way.begin.v;
  const bool along_u = std::fabs(du) > std::fabs(dv);
  const double sign = (along_u ? du : dv) < 0.0 ? -1.0 : 1.0;
  const auto place = [&](const Vec2& p) { return sign * (along_u ? p.u : p.v); };
  const double slack = kSlack * (std::fabs(place(m_lo)) + std::fabs(place(m_hi)));
  double limit = kInf;
  const auto look = [&](std::size_t i) {
    double s[3];
    const int n = line_crossings(m_pieces[i], a, b, c, s);
    for (int k = 0; k < n; ++k) {
      const Vec2 p = m_pieces[i].at(s[k]);
      if (visit(static_cast<std::uint32_t>(i), s[k], p)) limit = std::min(limit, place(p) + slack);
    }
  };
  m_search.along(way, [&](std::size_t i) {
    if (count == kMost) {
      look(i);
      return true;
    }
    const double begin = place(sign > 0.0 ? m_boxes[i].lo : m_boxes[i].hi);
    int at = count++;
    for (; at > 0 && waiting[at - 1].begin > begin; --at) waiting[at] = waiting[at - 1];
    waiting[at] = {begin, i};
    return true;
  });
  for (int k = 0; k < count && !(waiting[k].begin > limit); ++k) look(waiting[k].piece);
}

}  // namespace lentray::core
