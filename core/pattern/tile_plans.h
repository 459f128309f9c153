// The periodic tilings of the pattern `tiling`, by number: 1 to 24.
// Space: the pattern's own. Pure functions. Source: the pictures of reference manual 3.7, "Tiling
// Pattern"; places and levels measured on stock.
#pragma once

#include "core/pattern/tile_lattice.h"

namespace lentray::core {

/// Squares, rectangles and what comes of halving them: 1, 6, 10 to 15 and 18. Throws
/// std::invalid_argument for another number.
TilePlan plan_of_squares(int number);
/// Triangles, lozenges and regular polygons: the others.
TilePlan plan_of_polygons(int number);

}  // namespace lentray::core
