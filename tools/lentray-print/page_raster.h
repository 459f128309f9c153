// A page as pixels: pictures as they are, bars and strokes by the share of a pixel that they cover.
// Values: as files store them, 0 to 1 (no gamma is applied). Errors: core::NoRoom. Threads: any number.
#pragma once

#include <cstdint>

#include "core/image/image.h"
#include "tools/lentray-print/page.h"

namespace lentray::print {

/// A part of the page's grid of pixels.
struct Window {
  std::int64_t column = 0, row = 0;
  std::uint32_t width = 0, height = 0;
  bool operator==(const Window&) const = default;
};

core::Image drawn(const Page& page, const Window& window);
/// As RGB of 8 or 16 bits.
core::StoredImage stored_window(const Page& page, const Window& window, int bits);

}  // namespace lentray::print
