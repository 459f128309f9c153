// A pixel of the picture that is rendered, and a part of the picture.
#pragma once

#include <cstdint>

namespace lentray::core {

/// Row 0 is on top.
struct Pixel {
  std::uint32_t column = 0, row = 0;
};

/// Columns [left, right), rows [top, bottom).
struct PixelRegion {
  std::uint32_t left = 0, top = 0, right = 0, bottom = 0;
  bool has(const Pixel& p) const {
    return p.column >= left && p.column < right && p.row >= top && p.row < bottom;
  }
};

}  // namespace lentray::core
