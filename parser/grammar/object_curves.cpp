// Shapes made of curves.
// Source: reference manual 3.7, "Lathe", "Prism", "Surface of Revolution", "Sphere Sweep".
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "parser/grammar/helpers.h"
#include "parser/grammar/object.h"
#include "parser/grammar/object_shapes.h"

namespace lentray::parser {
namespace {

std::optional<CurveKind> accept_curve_kind(Parser& parser) {
  if (parser.accept(Keyword::kLinearSpline)) return CurveKind::kLinear;
  if (parser.accept(Keyword::kQuadraticSpline)) return CurveKind::kQuadratic;
  if (parser.accept(Keyword::kCubicSpline)) return CurveKind::kCubic;
  if (parser.accept(Keyword::kBezierSpline)) return CurveKind::kBezier;
  if (parser.accept(Keyword::kBSpline)) return CurveKind::kB;
  if (parser.accept(Keyword::kNaturalSpline)) return CurveKind::kNatural;
  return std::nullopt;
}

std::vector<Vec2> parse_points(Parser& parser, int count) {
  std::vector<Vec2> points;
  for (int i = 0; i < count; ++i) {
    parser.parse_comma();
    points.push_back(parse_uv(parser));
  }
  return points;
}

/// Points that a piece of an outline spans, and which of them it starts and ends at.
struct OutlineStep {
  std::size_t span, start, end;
};

/// The outlines of a prism must close: stock closes the last one if it is of straight lines, and
/// leaves out others.
void check_outline(Parser& parser, const Location& where, PrismShape& s) {
  std::vector<Vec2>& p = s.points;
  if (s.spline == CurveKind::kBezier) {
    if (p.size() % 4 != 0) {
      parser.fail_at(where, "A prism of a Bezier spline needs four points a segment.");
    }
    return;
  }
  const OutlineStep step = s.spline == CurveKind::kLinear      ? OutlineStep{1, 0, 1}
                           : s.spline == CurveKind::kQuadratic ? OutlineStep{2, 1, 2}
                                                               : OutlineStep{3, 1, 2};
  std::size_t first = 0;
  bool open = true;
  for (std::size_t i = 0; i + step.span < p.size(); ++i) {
    open = !(p[i + step.end] == p[first + step.start]);
    if (open) continue;
    i += step.span;
    first = i + 1;
  }
  if (!open) return;
  if (s.spline == CurveKind::kLinear) {
    parser.warn_at(where, "This prism is not closed: closing it.");
    p.push_back(p[first]);
  } else if (first == 0) {
    parser.fail_at(where,
                   "This prism is not closed: its outline must come back to its first point.");
  } else {
    parser.warn_at(where, "An outline of this prism is not closed: it is left out.");
    p.resize(first);
  }
}

/// No distance below 0, and heights that rise; those of the ends only from their neighbour's
/// neighbour.
void check_sor(Parser& parser, const std::vector<Vec2>& points) {
  constexpr double kLeast = 1e-10;
  const std::size_t n = points.size();
  for (std::size_t i = 0; i < n; ++i) {
    const bool falls = i > 1 && i + 1 < n && points[i].v <= points[i - 1].v;
    const bool flat = i > 1 && std::fabs(points[i].v - points[i - 2].v) < kLeast;
    if (points[i].u < 0.0 || falls || flat) {
      parser.fail("Incorrect point in surface of revolution.");
    }
  }
}

}  // namespace

ShapeDesc parse_lathe(Parser& parser, Context&) {
  LatheShape s;
  if (const auto kind = accept_curve_kind(parser)) s.spline = *kind;
  const int count = parser.parse_int();
  const int least = s.spline == CurveKind::kLinear ? 2 : s.spline == CurveKind::kQuadratic ? 3 : 4;
  if (count < least) {
    parser.fail("A lathe of this spline needs at least " + std::to_string(least) + " points.");
  }
  s.points = parse_points(parser, count);
  return s;
}

ShapeDesc parse_prism(Parser& parser, Context&) {
  PrismShape s;
  while (true) {
    if (const auto kind = accept_curve_kind(parser)) {
      s.spline = *kind;
    } else if (parser.accept(Keyword::kLinearSweep)) {
      s.conic_sweep = false;
    } else if (parser.accept(Keyword::kConicSweep)) {
      s.conic_sweep = true;
    } else {
      break;
    }
  }
  parse_values(parser, s.height1, s.height2);
  parser.parse_comma();
  const int count = parser.parse_int();
  if (count < 3) parser.fail("A prism must have at least three points.");
  const Location where = parser.location();
  s.points = parse_points(parser, count);
  check_outline(parser, where, s);
  s.open = parser.accept(Keyword::kOpen);
  return s;
}

ShapeDesc parse_sor(Parser& parser, Context&) {
  SorShape s;
  const int count = parser.parse_int();
  if (count < 4) parser.fail("A surface of revolution must have at least four points.");
  s.points = parse_points(parser, count);
  check_sor(parser, s.points);
  s.open = parser.accept(Keyword::kOpen);
  return s;
}

ShapeDesc parse_sphere_sweep(Parser& parser, Context&) {
  SphereSweepShape s;
  const Location where = parser.location();
  const auto kind = accept_curve_kind(parser);
  if (!kind ||
      (*kind != CurveKind::kLinear && *kind != CurveKind::kCubic && *kind != CurveKind::kB)) {
    parser.fail_at(where, "A sphere_sweep begins with linear_spline, cubic_spline or b_spline.");
  }
  s.spline = *kind;
  const int count = parser.parse_int();
  const int least = s.spline == CurveKind::kLinear ? 2 : 4;
  if (count < least) {
    parser.fail("A sphere_sweep of this spline needs at least " + std::to_string(least) +
                " spheres.");
  }
  for (int i = 0; i < count; ++i) {
    parser.parse_comma();
    s.centres.push_back(parser.parse_vector());
    parser.parse_comma();
    s.radii.push_back(parser.parse_float());
  }
  parser.parse_comma();
  if (parser.accept(Keyword::kTolerance)) s.tolerance = parser.parse_float();
  return s;
}

}  // namespace lentray::parser
