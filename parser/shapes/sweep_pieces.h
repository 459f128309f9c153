// The spheres of a sphere_sweep -> the pieces of its path.
// Source: reference manual 3.7, "Sphere Sweep"; compared with stock by tests/image/shapes_test.cpp.
#pragma once

#include <vector>

#include "core/shape/sphere_sweep.h"
#include "parser/descriptions/object.h"

namespace lentray::parser {

/// Throws std::runtime_error if there are too few spheres for the spline.
std::vector<core::SweepPiece> sweep_pieces(const SphereSweepShape& sweep);

}  // namespace lentray::parser
