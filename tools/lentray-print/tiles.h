// A sheet that is larger than the paper, cut into pages that overlap. Each page has a window of the whole, pixel for
// pixel; ticks outside of it show where to cut, between two lenses.
// Units: mm, or pixels of the whole page's grid. Errors: PageError, worded for the user. Pure.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "parser/options/length.h"
#include "tools/lentray-print/page.h"
#include "tools/lentray-print/page_raster.h"

namespace lentray::print {

struct TileStyle {
  parser::Extent paper;  ///< either way round, whichever takes fewer pages
  double margin = 5.0;   ///< blank border of the paper
  double overlap = 10.0;
};

struct Tile {
  int row = 0, column = 0;  ///< from 0
  Window window;            ///< of the whole page
  /// Where it is cut, in the whole page's columns and rows; at the sheet's own edges there is no cut.
  std::vector<std::int64_t> cut_columns, cut_rows;
};

struct TilePlan {
  parser::Extent paper;  ///< as it lies
  int rows = 0, columns = 0;
  std::vector<Tile> tiles;         ///< row by row
  std::int64_t left = 0, top = 0;  ///< where the window is on each page, pixels
};

/// `boundaries`: columns between lenses, where cuts may be.
TilePlan tile_plan(const Page& whole, const std::vector<std::int64_t>& boundaries,
                   const TileStyle& style);
/// `bits`: 8 or 16.
Page tile_page(const Page& whole, const TilePlan& plan, const Tile& tile, int bits);
/// "-r1-c2"
std::string suffix_of(const Tile& tile);

}  // namespace lentray::print
