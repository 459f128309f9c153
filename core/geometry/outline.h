// A flat region bounded by closed curves of line, quadratic and cubic pieces: what text and prisms
// sweep through space. Plane coordinates (u, v); even-odd rule.
// Robust at vertices: a point belongs to a line's one side or the other, never to both, and pieces
// share their end points, so a line meets the boundary an even number of times.
// Immutable; any number of threads.
#pragma once

#include <cstdint>
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
  static bool may_cross(const Box& box, double a, double b, double c);

  std::vector<CurvePiece> m_pieces;
  std::vector<Box> m_boxes;
  Vec2 m_lo, m_hi;
};

/// Parameters in 0..1 at which the piece crosses the line, at most three; the number of them.
int line_crossings(const CurvePiece& piece, double a, double b, double c, double s[3]);

template <class Visit>
void Outline::crossings(double a, double b, double c, const Box& region, Visit&& visit) const {
  for (std::uint32_t i = 0; i < m_pieces.size(); ++i) {
    if (!m_boxes[i].meets(region) || !may_cross(m_boxes[i], a, b, c)) continue;
    double s[3];
    const int n = line_crossings(m_pieces[i], a, b, c, s);
    for (int k = 0; k < n; ++k) visit(i, s[k]);
  }
}

}  // namespace lentray::core
