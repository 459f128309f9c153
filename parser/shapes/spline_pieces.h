// The control points of prism and lathe -> pieces of curves. Plane coordinates as written.
// Source: reference manual 3.7, "Prism", "Lathe"; compared with stock by tests/image/shapes_test.cpp.
#pragma once

#include <vector>

#include "core/shape/outline.h"
#include "parser/descriptions/object.h"

namespace lentray::parser {

/// `closing`: a point equal to a curve's first ends the curve, and another begins (as prism's).
/// Throws std::runtime_error if there are too few points.
std::vector<core::CurvePiece> spline_pieces(CurveKind kind, const std::vector<core::Vec2>& points,
                                            bool closing);

}  // namespace lentray::parser
