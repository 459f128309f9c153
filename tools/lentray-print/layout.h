// Several pictures on one lens sheet: which rows and columns they stand in, and at which lenses.
//
// The sheet's lenses have one pitch all over. A picture stands so that its middle is over the middle of a lens, or over
// the edge between two if it has an even number of them. Within a picture strips have their own pitch, which is larger
// than that of the lenses where it is made for a near eye: each picture is right by itself once it is cut off.
// Units: columns and rows of pixels, lenses. Errors: PageError, worded for the user. Pure.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "core/numeric/lens_columns.h"

namespace lentray::print {

/// A picture as it is cut out, and how much of its own lies before that.
struct LayoutItem {
  std::int64_t lenses = 0, rows = 0;
  std::int64_t first_lens = 0, first_row = 0;
};

struct LayoutGrid {
  int columns = 1, rows = 1;
  int places() const { return columns * rows; }
  bool operator==(const LayoutGrid&) const = default;
};

struct LayoutStyle {
  double strip = 1.0;   ///< N: columns from strip to strip
  double lens = 1.0;    ///< columns from lens to lens of the sheet
  double origin = 0.0;  ///< of the first picture's lens 0 beside a whole column
  std::int64_t gap_lenses = 0, gap_rows = 0;  ///< between what is cut out
  std::int64_t more_lenses =
      0;  ///< that a gap may grow by where pictures then stand at whole columns
};

/// Where a picture's own first lens and row are, from those of the first picture.
struct LayoutPlace {
  std::int64_t column = 0, row = 0;
  double origin = 0.0;  ///< where its lens 0 begins, from that column: -1/2 to 1/2
};

struct Layout {
  LayoutGrid grid;
  std::vector<LayoutPlace> places;  ///< row by row
  /// Strips about the middle of the whole, for marks; lens 0 begins with what is cut out.
  core::LensColumns marks;
  std::int64_t lenses = 0, rows = 0;  ///< of all that is cut out and of its gaps
};

/// Within this a picture stands at whole columns and is not mixed, in columns.
inline constexpr double kWholeColumn = 0.005;

/// At least one item. A grid larger than needed is left empty at its end.
Layout layout_of(const std::vector<LayoutItem>& items, LayoutGrid grid, const LayoutStyle& style);

/// The grid for `count` pictures whose `extent` (of a grid: width plus height, negative if it has no room) is least, the
/// widest of several; without columns if none has room.
LayoutGrid best_grid(int count, const std::function<double(const LayoutGrid&)>& extent);

/// How far the middle of so many lenses must be moved, -1/2 to 1/2, to lie as it did among the columns once strips are
/// `to` columns apart and not `from`: pixels in the middle then keep their places behind the lenses.
double origin_about_middle(std::int64_t lenses, double from, double to);

}  // namespace lentray::print
