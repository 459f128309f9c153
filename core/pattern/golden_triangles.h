// Penrose's tilings of two kinds of tiles, kites and darts or wide and narrow rhombs, as a pattern.
//
// Both are made of halves of tiles, triangles with sides of 1 and the golden ratio. Such a triangle can
// be cut into smaller ones of the same two forms: a point is looked up in a triangle that is large
// enough, then in the part that holds it, until the parts have the size of tiles. Space: the pattern's
// own, with five axes of symmetry through the origin. Values: 0..1/2 in kites and wide rhombs,
// 1/2..1 in darts and narrow ones. Immutable, any number of threads, no allocation after it is made.
// Source: R. M. Robinson's triangles, as in B. Gruenbaum and G. C. Shephard, "Tilings and Patterns",
// 10.3; place, size and bevels measured on stock.
#pragma once

#include "core/pattern/pattern.h"

namespace lentray::core {

enum class GoldenTiles { kKitesAndDarts, kRhombs };

PatternPtr make_golden_triangles(GoldenTiles tiles);

}  // namespace lentray::core
