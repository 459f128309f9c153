// Which lens of a sheet a column of pixels lies behind, and how many lenses a picture has: one rule for all who ask.
// A column belongs to the lens behind which its middle lies. A lens is whole if no column of its own is missing: what
// it lacks then is half a pixel at most, which is rounding.
// Units: columns. Errors: none. Any number of threads.
#pragma once

#include <cmath>
#include <cstdint>

namespace lentray::core {

struct LensColumns {
  double pixels = 1.0;  ///< N, pixels a lens, 1 or more; may be fractional
  double origin = 0.0;  ///< where lens 0 begins

  /// Of a column, of the picture or beyond its edges: floor((k + 1/2 - origin)/N).
  std::int64_t lens_of(std::int64_t column) const {
    return static_cast<std::int64_t>(
        std::floor((static_cast<double>(column) + 0.5 - origin) / pixels));
  }
  /// The first column that belongs to a lens.
  std::int64_t first_column(std::int64_t lens) const {
    auto column = static_cast<std::int64_t>(std::ceil(edge(static_cast<double>(lens)) - 0.5));
    // The quotient of lens_of() decides, whichever way it was rounded.
    while (lens_of(column) < lens) ++column;
    while (lens_of(column - 1) >= lens) --column;
    return column;
  }
  /// Where a lens begins; of i + 1/2, its middle.
  double edge(double lens) const { return origin + lens * pixels; }
  /// Lenses from 0 on that have all of their columns among the first `width`.
  std::int64_t whole_lenses(std::uint32_t width) const { return lens_of(width); }
  /// Whether the last of `width` > 0 columns belongs to a lens that lacks others.
  bool is_last_cut(std::uint32_t width) const {
    return lens_of(std::int64_t{width} - 1) == lens_of(width);
  }
  /// How many there are, as it is reported: a whole number, or the quotient where the last one is cut.
  double counted(std::uint32_t width) const {
    return is_last_cut(width) ? width / pixels : static_cast<double>(whole_lenses(width));
  }
};

}  // namespace lentray::core
