// The columns of a picture as lenses and their views and strips see them. Without a sheet a picture
// has one view, and strips run along its rows as if it were one lens.
// Pure functions, any number of threads.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "camera/lens_sheet.h"

namespace lentray::shadow {

/// Columns [begin, end).
struct Strip {
  std::uint32_t begin = 0, end = 0;
};

/// The columns behind each lens; all in one without a sheet.
std::vector<Strip> lenses_of(std::uint32_t width, const camera::LensSheet* sheet);

/// The columns below `width`, view after view, each from the left. View j: pixel j, counted from
/// the left, of all lenses; where N is not whole, the last view has only the wider lenses.
std::vector<std::vector<std::uint32_t>> columns_by_view(std::size_t width,
                                                        const camera::LensSheet* sheet);

/// Lenses cut into strips of `strip_width` columns, the last of a lens perhaps narrower: strip 0 of
/// every lens, then strip 1 of every lens, and so on. Every column below `width` is in one.
std::vector<Strip> strips_of_lenses(std::size_t width, const camera::LensSheet* sheet,
                                    std::uint32_t strip_width);

}  // namespace lentray::shadow
