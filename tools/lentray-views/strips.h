// What is in an integral image: views, lens sub-images, and what an eye sees through the sheet.
// Every pixel of these pictures is one of the integral image's, or with `between` a mean of two in
// linear light; all have the integral image's height.
// Errors: core::ImageError, worded for the user. Threads: any number.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "camera/lens_sheet.h"
#include "core/image/reader.h"

namespace lentray::views {

/// There are `count` views.
[[noreturn]] void refuse_view(std::uint32_t view, std::uint32_t count);

/// View j of `count`: one pixel a lens, that whose print offset is nearest to
/// ((j + 1/2)/count - 1/2) P'. A last lens that is cut may lack it.
core::StoredImage view_of(const core::StoredImage& integral, const camera::LensSheet& sheet,
                          std::uint32_t view, std::uint32_t count);

/// The columns behind a lens.
core::StoredImage lens_of(const core::StoredImage& integral, const camera::LensSheet& sheet,
                          std::uint32_t lens);

/// An eye before the sheet, relative to the sheet's middle; to the right is positive.
struct Eye {
  double angle = 0.0;     ///< degrees from the sheet's normal
  double distance = 0.0;  ///< mm from the sheet; 0: infinite
};

/// For each lens the print that the lens model shows in the direction of the eye, be it its own
/// strip or that of a lens beside it; black where the print has ended. `between`: linear between
/// the middles of pixels instead of the nearest pixel.
core::StoredImage seen_by(const core::StoredImage& integral, const camera::LensSheet& sheet,
                          const Eye& eye, bool between);

/// The place in the print that a place of a row shows, in pixels: 0 is the middle of the first column.
using PlaceInPrint = std::function<double(std::uint32_t place, std::uint32_t row)>;
/// A picture of those places, so many in a row; black where the print has ended.
core::StoredImage seen_at(const core::StoredImage& integral, std::uint32_t width, bool between,
                          const PlaceInPrint& place_of);

/// For each lens the place in the print that the eye sees, in pixels: 0 is the middle of the first column.
std::vector<double> places_seen(const camera::LensSheet& sheet, const Eye& eye);

}  // namespace lentray::views
