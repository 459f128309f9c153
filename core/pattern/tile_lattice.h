// Convex tiles that repeat along two directions of the x-z plane, as a pattern.
//
// The plane is cut into equal parallelograms, one a period; a parallelogram is cut into kCells x kCells
// cells, and each knows which tiles reach into it. A point is moved into the first parallelogram and
// looked up in its cell; the tile that holds it gives the value. Space: the pattern's own. Values:
// 0..1. Immutable, any number of threads, no allocation after it is made.
#pragma once

#include <vector>

#include "core/pattern/pattern.h"

namespace lentray::core {

struct PlanePoint {
  double x = 0.0, z = 0.0;
};

struct Tile {
  int level = 0;                    ///< its kind, from 0
  std::vector<PlanePoint> corners;  ///< around it, in either sense; convex
  std::vector<double> bevels = {};  ///< of each edge from its corner on; empty: the plan's
};

struct TilePlan {
  PlanePoint first_step, second_step;  ///< the tiling repeats along both
  int levels = 1;                      ///< kinds of tiles
  double bevel = 0.5;                  ///< how far from an edge a tile is flat
  std::vector<Tile> tiles = {};        ///< one of each that repeats
  /// Edges belong to the tile listed first, otherwise to the one at larger coordinates.
  bool edges_by_order = false;
};

PatternPtr make_tile_lattice(const TilePlan& plan);

}  // namespace lentray::core
