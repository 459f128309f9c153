// Views as a moving picture: to and fro, as an eye before the sheet moves, or again and again from the first one, as
// the phases of an animation.
// Errors: core::ImageError, worded for the user. One thread.
#pragma once

#include <cstdint>
#include <vector>

#include "tools/lentray-views/arguments.h"
#include "tools/lentray-views/source.h"

namespace lentray::views {

/// In which order views are shown, of `first` to `last`; both ends of a way to and fro once.
std::vector<std::uint32_t> order_of_frames(const Range& range, bool is_loop);

/// The size of a frame where none is asked for: square pixels, at most as many as people look at on a screen.
/// `aspect`: width by height as it is looked at; 0: pixels are square.
Size size_of_frame(std::uint32_t width, std::uint32_t height, double aspect);

/// The frames. All have one size.
std::vector<core::StoredImage> frames_of(const Arguments& arguments, const Source& source,
                                         const Range& range);

}  // namespace lentray::views
