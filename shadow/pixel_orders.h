// Pixel orders by name, as `Pixel_Order=` takes it, cut into jobs: bands of whole rows or whole
// columns, small enough that every thread has work to the end, large enough that a cache sees
// runs of neighbours. The order of pixels never changes the picture.
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "core/render/pixel_order.h"

namespace lentray::shadow {

/// The part of the image to render, in pixels: columns [left, right), rows [top, bottom).
struct PixelRegion {
  std::uint32_t left = 0, top = 0, right = 0, bottom = 0;
};

/// rows, columns: in this order.
const std::vector<std::string_view>& order_names();

/// Throws std::invalid_argument with the list of names for one that is not there (letter case
/// does not matter). An empty region has no jobs.
std::unique_ptr<core::PixelOrder> make_order(std::string_view name, const PixelRegion& region);
std::unique_ptr<core::PixelOrder> make_order(std::string_view name, std::uint32_t width,
                                             std::uint32_t height);

}  // namespace lentray::shadow
