// The pattern pavement: one polyform tile paves the x-z plane. A tile is some equal triangles, squares
// or hexagons of side 1, joined along their sides.
//
// Space: the pattern's own, y does not matter. Values: 0 inside a tile, rising to 1 at its edge.
// Immutable, any number of threads, no allocation after it is made.
// Source: reference manual 3.7, "Pavement Pattern"; geometry and values compared with stock by
// tests/image/pavements_test.cpp.
#pragma once

#include "core/pattern/pattern.h"

namespace lentray::core {

struct Pavement {
  int sides = 3;     ///< of a polygon: 3, 4 or 6
  int tiles = 1;     ///< polygons in a tile
  int pattern = 1;   ///< which tile of so many polygons
  int exterior = 0;  ///< pointed corners of a tile: 0 as they are, 1 cut off, 2 round
  int interior = 0;  ///< where other tiles' corners poke in: 0 sharp, 1 cut off, 2 round
  int form = 0;  ///< turns: 0 sharp, 1 cut off, 2 round; of squares 3: as interior and exterior say
};

/// How many patterns there are of that many polygons; 0 where a tile cannot have so many.
int pavement_patterns(int sides, int tiles);

/// Throws std::invalid_argument where there is no such pattern.
PatternPtr make_pavement(const Pavement& pavement);

}  // namespace lentray::core
