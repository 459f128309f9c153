#include "parser/shapes/spline_pieces.h"

#include <cmath>
#include <stdexcept>

namespace lentray::parser {
namespace {

using core::CurvePiece;
using core::Vec2;

Vec2 mix(double a, const Vec2& p, double b, const Vec2& q, double c, const Vec2& r, double d = 0.0,
         const Vec2& s = {}) {
  return {a * p.u + b * q.u + c * r.u + d * s.u, a * p.v + b * q.v + c * r.v + d * s.v};
}

bool close(const Vec2& a, const Vec2& b) {
  constexpr double kClose = 1e-10;
  return std::fabs(a.u - b.u) < kClose && std::fabs(a.v - b.v) < kClose;
}

/// Points a piece reaches beyond its first, and the index among them of where it starts and ends.
struct Layout {
  std::size_t span, start, end;
};

Layout layout_of(CurveKind kind) {
  switch (kind) {
    case CurveKind::kLinear: return {1, 0, 1};
    case CurveKind::kQuadratic: return {2, 1, 2};
    case CurveKind::kCubic: return {3, 1, 2};
    case CurveKind::kBezier: return {3, 0, 3};
    default: throw std::runtime_error("this kind of spline is not known here");
  }
}

CurvePiece piece_of(CurveKind kind, const Vec2* p, bool closing) {
  switch (kind) {
    case CurveKind::kQuadratic:
      return {{},
              mix(0.5, p[0], -1.0, p[1], 0.5, p[2]),
              mix(-0.5, p[0], 0.0, p[1], 0.5, p[2]),
              p[1],
              p[2]};
    case CurveKind::kCubic:
      return {mix(-0.5, p[0], 1.5, p[1], -1.5, p[2], 0.5, p[3]),
              mix(1.0, p[0], -2.5, p[1], 2.0, p[2], -0.5, p[3]),
              mix(-0.5, p[0], 0.0, p[1], 0.5, p[2]), p[1], p[2]};
    // Through those of a prism stock runs from the last point to the first.
    case CurveKind::kBezier:
      return closing ? CurvePiece::bezier(p[3], p[2], p[1], p[0])
                     : CurvePiece::bezier(p[0], p[1], p[2], p[3]);
    default: return CurvePiece::line(p[0], p[1]);
  }
}

}  // namespace

std::vector<CurvePiece> spline_pieces(CurveKind kind, const std::vector<Vec2>& points,
                                      bool closing) {
  const Layout layout = layout_of(kind);
  std::vector<CurvePiece> pieces;
  const std::size_t step = kind == CurveKind::kBezier ? 4 : 1;
  pieces.reserve(points.size() / step);
  std::size_t first = 0;  // of the curve
  for (std::size_t i = 0; i + layout.span < points.size(); i += step) {
    pieces.push_back(piece_of(kind, &points[i], closing));
    if (!closing || kind == CurveKind::kBezier) continue;
    if (close(points[i + layout.end], points[first + layout.start])) {
      i += layout.span;
      first = i + 1;
    }
  }
  if (pieces.empty()) throw std::runtime_error("too few points for this spline");
  return pieces;
}

}  // namespace lentray::parser
