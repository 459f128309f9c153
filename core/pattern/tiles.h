// Patterns that cut space into pieces, each a whole number: 0, 1, 2 ...; brick: 0 mortar, 1 brick.
// Source: reference manual 3.7, "Checker", "Brick", "Hexagon", "Square", "Triangular", "Cubic".
#pragma once

#include "core/pattern/pattern.h"

namespace lentray::core {

PatternPtr make_checker();
PatternPtr make_hexagon();
PatternPtr make_square();
PatternPtr make_triangular();
PatternPtr make_cubic();
/// Sizes include the mortar.
PatternPtr make_brick(const Vec3& size, double mortar);
/// A random number in each unit cube.
PatternPtr make_cells();

}  // namespace lentray::core
