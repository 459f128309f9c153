// Where the walls between the tiles of each pavement stand. Space: a lattice of unit squares, or of
// rhombs of two unit triangles. Pure functions. Source: measured on stock.
#pragma once

#include <span>

namespace lentray::core {

/// A period of the lattice. Each node has a digit, the sum of the walls that leave it: 1 along the
/// first direction, 2 along the second, 4 from the next node along the first to the next along the
/// second. A row is the nodes along the first direction; the period above a period begins `shift`
/// nodes further on.
struct PavementWalls {
  int shift;
  const char* rows;  ///< from below, separated by spaces
};

/// One for each pattern; empty where a tile cannot have so many polygons.
std::span<const PavementWalls> pavement_walls(int sides, int tiles);

}  // namespace lentray::core
