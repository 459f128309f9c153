// A flat region bounded by closed curves of line, quadratic and cubic pieces: what text and prisms
// sweep through space. Plane coordinates (u, v); even-odd rule.
// Robust at vertices: a point belongs to a line's one side or the other, never to both, and pieces
// share their end points, so a line meets the boundary an even number of times.
// Immutable; any number of threads.
#pragma once

#include <algorithm>
#include <cstdint>
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
  struct Box {
    Vec2 lo, hi;
    bool meets(const Box& o) const {
      return lo.u <= o.hi.u && hi.u >= o.lo.u && lo.v <= o.hi.v && hi.v >= o.lo.v;
    }
  };
  /// Calls visit(piece, s) where the line a u + b v + c = 0 crosses the boundary; elsewhere than in
  /// `region` it may leave crossings out.
  template <class Visit>
  void crossings(double a, double b, double c, const Box& region, Visit&& visit) const;
  const std::vector<CurvePiece>& pieces() const { return m_pieces; }
  /// As Shape::drop_shortcuts(); lo() and hi() become infinite.
  void drop_boxes();
  const Vec2& lo() const { return m_lo; }
  const Vec2& hi() const { return m_hi; }

 private:
  static Box box_of(const CurvePiece& piece);
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
  static bool may_cross(const Box& box, double a, double b, double c);

  std::vector<CurvePiece> m_pieces;
  std::vector<Box> m_boxes;
  Vec2 m_lo, m_hi;
  int m_bands = 1;
  double m_bands_per_v = 0.0;
  std::vector<std::uint32_t> m_in_bands, m_band_starts;
};

/// Parameters in 0..1 at which the piece crosses the line, at most three; the number of them.
int line_crossings(const CurvePiece& piece, double a, double b, double c, double s[3]);

template <class Visit>
void Outline::crossings(double a, double b, double c, const Box& region, Visit&& visit) const {
  const auto look = [&](std::uint32_t i) {
    if (!m_boxes[i].meets(region) || !may_cross(m_boxes[i], a, b, c)) return;
    double s[3];
    const int n = line_crossings(m_pieces[i], a, b, c, s);
    for (int k = 0; k < n; ++k) visit(i, s[k]);
  };
  const int band = band_of(region.lo.v);
  if (band == band_of(region.hi.v)) {
    for (const std::uint32_t i : in_band(band)) look(i);
  } else {
    for (std::uint32_t i = 0; i < m_pieces.size(); ++i) look(i);
  }
}

}  // namespace lentray::core
