// Line gratings on a grid of pixels, exact at any pitch: a pixel is as dark as the share of it that lines cover, so that
// no rounding adds up along a grating.
// Units: pixels of the grid; phases and edges in periods. Errors: none. Pure.
#pragma once

#include <cstdint>

#include "tools/lentray-print/page.h"

namespace lentray::print {

/// At place x, u = (x - origin) / period; ink where `from` <= u - floor(u) < `to`.
struct Lines {
  double period = 1.0;
  double origin = 0.0;
  double from = 0.25, to = 0.75;  ///< within 0 .. 1
};

/// The share of left .. right that has ink, 0 to 1.
double inked_share(const Lines& lines, double left, double right);

/// What is seen of a grating between two places.
struct Grating {
  Lines lines;
  double left = 0.0, right = 0.0;  ///< ends, which need not be whole pixels
  bool is_hard =
      false;  ///< pixels are ink or not, by the greater share: no grey, edges up to half a pixel off
};

/// A picture of the pixels that the grating touches, `rows` high, its upper left pixel at (floor(left), row). Grey of
/// 8 bits; in colour where ink and background are not black and white.
Picture grating(const Grating& grating, std::int64_t row, std::uint32_t rows, const Page& page);

}  // namespace lentray::print
