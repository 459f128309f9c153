// The pattern tiling: tiles that cover the x-z plane, each bevelled from its middle to its edge.
// Space: the pattern's own, y does not matter; most edges have length 1. Values: tiling n has L kinds
// of tiles, and those of kind k go from k/L in the middle to (k+1)/L at the edge. Immutable, any
// number of threads, no allocation after it is made.
// Source: reference manual 3.7, "Tiling Pattern"; geometry and values compared with stock by
// tests/image/tilings_test.cpp.
#pragma once

#include "core/pattern/pattern.h"

namespace lentray::core {

/// 1 to 27: 25 and on do not repeat. Throws std::invalid_argument for another number.
PatternPtr make_tiling(int number);

}  // namespace lentray::core
