// A flat region bounded by closed curves of line, quadratic and cubic pieces: what text and prisms
// sweep through space. Plane coordinates (u, v); even-odd rule.
// Robust at vertices: a point belongs to a line's one side or the other, never to both, and pieces
// share their end points, so a line meets the boundary an even number of times.
// Immutable; any number of threads.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/base/processor.h"
#include "core/base/vec3.h"

namespace lentray::core {

/// ((a s + b) s + c) s + d for s in 0..1. `end` is the point at s = 1, the start of the next piece.
struct CurvePiece {
  Vec2 a, b, c, d;
  Vec2 end;
  Vec2 at(double s) const;
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
  /// The most that direction.u u + direction.v v becomes.
  double farthest(const Vec2& direction) const;
  struct Box {
    Vec2 lo, hi;
    bool meets(const Box& o) const {
      return lo.u <= o.hi.u && hi.u >= o.lo.u && lo.v <= o.hi.v && hi.v >= o.lo.v;
    }
  };
  /// A straight way over the plane, as far as rounding tells; or any way within a region.
  struct Way {
    Box region{{-kInf, -kInf}, {kInf, kInf}};  ///< holds it
    Vec2 begin{}, end{};
    double slack = 0.0;     ///< how far it may be off in u or v; the region is wider by it
    bool is_known = false;  ///< all but the region
  };
  /// What a way comes to, known without counting: by the squares that it meets.
  struct Walk {
    std::uint32_t rows = 0, columns = 0;  ///< of the squares met that a piece may come into, a bit each
    bool meets_inside = false;            ///< a square met is inside, all of it
    bool is_sure = false;                 ///< so is a place on the way
    bool is_outside() const { return rows == 0 && !meets_inside; }
    bool is_inside_somewhere() const { return meets_inside && is_sure; }
  };
  /// `portable`: without AVX2 where there is any (the answer is the same).
  Walk walk(const Way& way, bool portable = false) const;
  /// Calls visit(piece, s), until that answers false, where the line a u + b v + c = 0 crosses the
  /// boundary; off the way it may leave crossings out. `walk`: that of the way.
  template <class Visit>
  void crossings(double a, double b, double c, const Way& way, const Walk& walk, Visit&& visit) const;
  /// The same for who looks for the first along a known way: visit() answers whether a crossing counts;
  /// those certainly beyond one that does may be left out. Any order.
  template <class Visit>
  void first_crossings(double a, double b, double c, const Way& way, const Walk& walk, Visit&& visit) const;
  const std::vector<CurvePiece>& pieces() const { return m_pieces; }
  /// As Shape::drop_shortcuts(); lo() and hi() become infinite.
  void drop_boxes();
  const Vec2& lo() const { return m_lo; }
  const Vec2& hi() const { return m_hi; }

 private:
  static Box box_of(const CurvePiece& piece);
  void fill_squares();
  void mark(std::size_t piece);
  void mark(std::size_t piece, const Box& box);
  bool contains_counted(double u, double v) const;
  /// The rows of squares that a way comes to, and where in them it is, in squares.
  struct Rows {
    int first, last;
    float begin = 0;   ///< of the first row, above the way's low end
    float rise = 0;    ///< of the whole way
    float column = 0;  ///< of the low end
    float columns_a_row = 0;
  };
  void meet(int row, std::uint32_t columns, Walk& walk) const;
  void meet_portable(const Rows& rows, Walk& walk) const;
  LENTRAY_AVX2 void meet_avx2(const Rows& rows, Walk& walk) const;
  /// Which column or row a place is in, beyond them the nearest.
  int column_of(double u) const { return square_of((u - m_lo.u) * m_columns_per_u); }
  int row_of(double v) const { return square_of((v - m_lo.v) * m_rows_per_v); }
  int square_of(double at) const {
    return at > 0.0 ? static_cast<int>(std::min(at, static_cast<double>(m_side - 1))) : 0;
  }
  /// Calls take(piece), until that answers false, for those that may cross the line on the way.
  template <class Take>
  void candidates(double a, double b, double c, const Way& way, const Walk& walk, Take&& take) const;
  static bool may_cross(const Box& box, double a, double b, double c);

  std::vector<CurvePiece> m_pieces;
  std::vector<Box> m_boxes;
  Vec2 m_lo, m_hi;
  /// Squares over lo() .. hi(), a bit each: those that a piece may come into, and of the others those
  /// inside.
  static constexpr int kMostSquares = 32;
  int m_side = 1;
  double m_columns_per_u = 0.0, m_rows_per_v = 0.0;
  std::array<std::uint32_t, kMostSquares + 7> m_mixed{}, m_inside{};  ///< more: eight are read at once
  /// The pieces that come into a row or a column, a bit each, m_words words a row or column.
  std::size_t m_words = 1;
  std::vector<std::uint64_t> m_in_rows, m_in_columns;
};

/// Parameters in 0..1 at which the piece crosses the line, at most three; the number of them.
int line_crossings(const CurvePiece& piece, double a, double b, double c, double s[3]);

inline bool Outline::may_cross(const Box& box, double a, double b, double c) {
  constexpr double kSlack = 1e-12;
  const double u = 0.5 * (box.lo.u + box.hi.u), v = 0.5 * (box.lo.v + box.hi.v);
  const double reach = std::fabs(a) * (box.hi.u - u) + std::fabs(b) * (box.hi.v - v);
  const double size = std::fabs(a * u) + std::fabs(b * v) + std::fabs(c);
  return !(std::fabs(a * u + b * v + c) > reach + kSlack * size);
}

template <class Take>
void Outline::candidates(double a, double b, double c, const Way& way, const Walk& walk, Take&& take) const {
  const auto in_any = [&](const std::vector<std::uint64_t>& sets, std::uint32_t of, std::size_t word) {
    std::uint64_t pieces = 0;
    for (; of != 0; of &= of - 1) pieces |= sets[static_cast<std::size_t>(std::countr_zero(of)) * m_words + word];
    return pieces;
  };
  for (std::size_t word = 0; word < m_words; ++word) {
    std::uint64_t pieces = in_any(m_in_rows, walk.rows, word) & in_any(m_in_columns, walk.columns, word);
    for (; pieces != 0; pieces &= pieces - 1) {
      const std::size_t i = 64 * word + static_cast<std::size_t>(std::countr_zero(pieces));
      if (way.region.meets(m_boxes[i]) && may_cross(m_boxes[i], a, b, c) && !take(static_cast<std::uint32_t>(i))) return;
    }
  }
}

template <class Visit>
void Outline::crossings(double a, double b, double c, const Way& way, const Walk& walk, Visit&& visit) const {
  candidates(a, b, c, way, walk, [&](std::uint32_t i) {
    double s[3];
    const int n = line_crossings(m_pieces[i], a, b, c, s);
    for (int k = 0; k < n; ++k) {
      if (!visit(i, s[k])) return false;
    }
    return true;
  });
}

/// By where their boxes begin, along the axis that the way is longer on.
template <class Visit>
void Outline::first_crossings(double a, double b, double c, const Way& way, const Walk& walk, Visit&& visit) const {
  constexpr double kSlack = 1e-6;
  constexpr int kMost = 16;
  struct Candidate {
    double begin;
    std::uint32_t piece;
  };
  Candidate waiting[kMost];
  int count = 0;
  const double du = way.end.u - way.begin.u, dv = way.end.v - way.begin.v;
  const bool along_u = std::fabs(du) > std::fabs(dv);
  const double sign = (along_u ? du : dv) < 0.0 ? -1.0 : 1.0;
  const auto place = [&](const Vec2& p) { return sign * (along_u ? p.u : p.v); };
  const double slack = kSlack * (std::fabs(place(m_lo)) + std::fabs(place(m_hi)));
  double limit = kInf;
  const auto look = [&](std::uint32_t i) {
    double s[3];
    const int n = line_crossings(m_pieces[i], a, b, c, s);
    for (int k = 0; k < n; ++k) {
      if (visit(i, s[k])) limit = std::min(limit, place(m_pieces[i].at(s[k])) + slack);
    }
  };
  candidates(a, b, c, way, walk, [&](std::uint32_t i) {
    const double begin = place(sign > 0.0 ? m_boxes[i].lo : m_boxes[i].hi);
    if (count == kMost) {
      look(i);
      return true;
    }
    int at = count++;
    for (; at > 0 && waiting[at - 1].begin > begin; --at) waiting[at] = waiting[at - 1];
    waiting[at] = {begin, i};
    return true;
  });
  for (int k = 0; k < count && !(waiting[k].begin > limit); ++k) look(waiting[k].piece);
}

}  // namespace lentray::core
