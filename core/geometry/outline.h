// A flat region bounded by closed curves of line, quadratic and cubic pieces: what text and prisms
// sweep through space. Plane coordinates (u, v); even-odd rule.
// Robust at vertices: a point belongs to a line's one side or the other, never to both, and pieces
// share their end points, so a line meets the boundary an even number of times.
// Immutable; any number of threads.
#pragma once

#include <immintrin.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

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
  /// Certain, known without counting; false: unknown.
  bool is_known_inside(const Vec2& p) const {
    return p.u >= m_lo.u && p.u <= m_hi.u && p.v >= m_lo.v && p.v <= m_hi.v &&
           (m_inside[static_cast<std::size_t>(row_of(p.v))] >> column_of(p.u) & 1u) != 0;
  }
  /// Calls visit(piece, s), until that answers false, where the line a u + b v + c = 0 crosses the
  /// boundary; elsewhere than in `region` it may leave crossings out.
  template <class Visit>
  void crossings(double a, double b, double c, const Box& region, Visit&& visit) const;
  /// The same for who looks for the first along the line, in the direction `way`: visit() answers
  /// whether a crossing counts; those certainly beyond one that does may be left out. Any order.
  template <class Visit>
  void first_crossings(double a, double b, double c, const Vec2& way, const Box& region, Visit&& visit) const;
  const std::vector<CurvePiece>& pieces() const { return m_pieces; }
  /// As Shape::drop_shortcuts(); lo() and hi() become infinite.
  void drop_boxes();
  const Vec2& lo() const { return m_lo; }
  const Vec2& hi() const { return m_hi; }

 private:
  static Box box_of(const CurvePiece& piece);
  /// As a float, rounded outwards; beyond floats the largest, which is as good.
  static float up(double x) {
    constexpr double kMost = 3e38;
    const auto f = static_cast<float>(std::clamp(x, -kMost, kMost));
    return f + __builtin_fabsf(f) * 0x1p-22f;
  }
  static float down(double x) { return -up(-x); }
  static constexpr int kMostBands = 16;
  /// Which band of v a place is in, beyond them the nearest; rises with v.
  int band_of(double v) const {
    const double at = (v - m_lo.v) * m_bands_per_v;
    return at > 0.0 ? static_cast<int>(std::min(at, static_cast<double>(m_bands - 1))) : 0;
  }
  /// The pieces, rising, that reach into a band.
  std::span<const std::uint32_t> in_band(int band) const {
    const auto i = static_cast<std::size_t>(band);
    return std::span(m_in_bands).subspan(m_band_starts[i], m_band_starts[i + 1] - m_band_starts[i]);
  }
  void fill_bands();
  void fill_lanes();
  void fill_squares();
  void mark(const CurvePiece& piece);
  void mark(const Box& box);
  bool contains_counted(double u, double v) const;
  /// Which column or row a place is in, beyond them the nearest.
  int column_of(double u) const { return square_of((u - m_lo.u) * m_columns_per_u); }
  int row_of(double v) const { return square_of((v - m_lo.v) * m_rows_per_v); }
  int square_of(double at) const {
    return at > 0.0 ? static_cast<int>(std::min(at, static_cast<double>(m_side - 1))) : 0;
  }
  /// Whether a piece may come into the region.
  bool has_pieces(const Box& region) const;
  /// Calls take(piece), until that answers false, for those that may cross the line in the region.
  template <class Take>
  void candidates(double a, double b, double c, const Box& region, Take&& take) const;
  static bool may_cross(const Box& box, double a, double b, double c);

  std::vector<CurvePiece> m_pieces;
  std::vector<Box> m_boxes;
  Vec2 m_lo, m_hi;
  int m_bands = 1;
  double m_bands_per_v = 0.0;
  std::vector<std::uint32_t> m_in_bands, m_band_starts;

  /// Four pieces' boxes, rounded outwards: low u, low v, high u, high v.
  struct alignas(16) Lanes { float sides[4][4]; };
  std::vector<Lanes> m_lanes;

  /// Squares over lo() .. hi(), a bit each: those that a piece may come into, and of the others those
  /// inside.
  static constexpr int kMostSquares = 32;
  int m_side = 1;
  double m_columns_per_u = 0.0, m_rows_per_v = 0.0;
  std::array<std::uint32_t, kMostSquares> m_mixed{}, m_inside{};
};

/// Parameters in 0..1 at which the piece crosses the line, at most three; the number of them.
int line_crossings(const CurvePiece& piece, double a, double b, double c, double s[3]);

inline bool Outline::has_pieces(const Box& region) const {
  if (!region.meets({m_lo, m_hi})) return false;
  const std::uint32_t columns = (2u << column_of(region.hi.u)) - (1u << column_of(region.lo.u));
  const int last = row_of(region.hi.v);
  std::uint32_t mixed = 0;
  for (int row = row_of(region.lo.v); row <= last; ++row) mixed |= m_mixed[static_cast<std::size_t>(row)];
  return (mixed & columns) != 0;
}

inline bool Outline::may_cross(const Box& box, double a, double b, double c) {
  constexpr double kSlack = 1e-12;
  const double u = 0.5 * (box.lo.u + box.hi.u), v = 0.5 * (box.lo.v + box.hi.v);
  const double reach = std::fabs(a) * (box.hi.u - u) + std::fabs(b) * (box.hi.v - v);
  const double size = std::fabs(a * u) + std::fabs(b * v) + std::fabs(c);
  return !(std::fabs(a * u + b * v + c) > reach + kSlack * size);
}

template <class Take>
void Outline::candidates(double a, double b, double c, const Box& region, Take&& take) const {
  constexpr std::size_t kMany = 16;  // groups: fewer are sooner looked at than the squares
  if (m_lanes.size() > kMany && !has_pieces(region)) return;
  const __m128 low_u = _mm_set1_ps(down(region.lo.u)), low_v = _mm_set1_ps(down(region.lo.v));
  const __m128 high_u = _mm_set1_ps(up(region.hi.u)), high_v = _mm_set1_ps(up(region.hi.v));
  const Lanes* group = m_lanes.data();
  const Lanes* const end = group + m_lanes.size();
  for (std::uint32_t first = 0; group < end; ++group, first += 4) {
    const auto& sides = group->sides;
    const __m128 meets_u = _mm_and_ps(_mm_cmple_ps(_mm_load_ps(sides[0]), high_u),
                                      _mm_cmpge_ps(_mm_load_ps(sides[2]), low_u));
    const __m128 meets_v = _mm_and_ps(_mm_cmple_ps(_mm_load_ps(sides[1]), high_v),
                                      _mm_cmpge_ps(_mm_load_ps(sides[3]), low_v));
    auto mask = static_cast<unsigned>(_mm_movemask_ps(_mm_and_ps(meets_u, meets_v)));
    for (; mask != 0; mask &= mask - 1) {
      const std::uint32_t i = first + static_cast<std::uint32_t>(std::countr_zero(mask));
      if (may_cross(m_boxes[i], a, b, c) && !take(i)) return;
    }
  }
}

template <class Visit>
void Outline::crossings(double a, double b, double c, const Box& region, Visit&& visit) const {
  candidates(a, b, c, region, [&](std::uint32_t i) {
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
void Outline::first_crossings(double a, double b, double c, const Vec2& way, const Box& region, Visit&& visit) const {
  constexpr double kSlack = 1e-6;
  constexpr int kMost = 16;
  struct Candidate {
    double begin;
    std::uint32_t piece;
  };
  Candidate waiting[kMost];
  int count = 0;
  const bool along_u = std::fabs(way.u) > std::fabs(way.v);
  const double sign = (along_u ? way.u : way.v) < 0.0 ? -1.0 : 1.0;
  const auto place = [&](const Vec2& p) { return sign * (along_u ? p.u : p.v); };
  const double slack = kSlack * (std::fabs(place(m_lo)) + std::fabs(place(m_hi)));
  double limit = std::numeric_limits<double>::infinity();
  const auto look = [&](std::uint32_t i) {
    double s[3];
    const int n = line_crossings(m_pieces[i], a, b, c, s);
    for (int k = 0; k < n; ++k) {
      if (visit(i, s[k])) limit = std::min(limit, place(m_pieces[i].at(s[k])) + slack);
    }
  };
  candidates(a, b, c, region, [&](std::uint32_t i) {
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
