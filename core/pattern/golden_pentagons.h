// Penrose's tiling of pentagons, stars, boats and diamonds, as a pattern.
//
// A tile that is larger by the golden ratio splits into tiles: a point is looked up in a pentagon that
// is large enough, then in the part that holds it, until the parts have the size of tiles. Pentagons
// are of three kinds by their neighbours. Space: the pattern's own; a pentagon with sides of length 1 is
// around the origin. Values: 0..3/6 in pentagons, then star, boat and diamond, each a sixth.
// Immutable, any number of threads, no allocation after it is made.
// Source: R. Penrose, "Pentaplexity", 1979; the cuts, sizes and bevels measured on stock.
#pragma once

#include "core/pattern/pattern.h"

namespace lentray::core {

PatternPtr make_golden_pentagons();

}  // namespace lentray::core
