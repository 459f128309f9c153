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

/// Columns in the order that they are traced in, as lists one behind another.
struct ColumnLists {
  std::vector<std::uint32_t> columns;
  std::vector<std::size_t> before{0};  ///< columns before each list; one more entry at the end

  /// The columns that were added last are a list, unless there are none.
  void end_list() {
    if (columns.size() > before.back()) before.push_back(columns.size());
  }
};

/// Lenses cut into strips of `width` columns, the last of a lens perhaps narrower: strip 0 of every
/// lens, then strip 1 of every lens, and so on. Every strip is a list, or, `joined`, all strips of the
/// same number are one. Columns before `left` are left out.
ColumnLists lists_of_strips(const std::vector<Strip>& lenses, std::uint32_t width,
                            std::uint32_t left, bool joined = false);

}  // namespace lentray::shadow
