// Pictures as the bytes of their files: a PNG; and moving pictures of some frames, shown again and
// again: an animated PNG, or a GIF.
// Frames have one size; they become 8 bits of sRGB.
// Errors: core::ImageError, worded for the user. Threads: any number.
// Source: PNG specification, third edition (W3C 2025), chunks acTL, fcTL and fdAT; GIF89a with the
// application block NETSCAPE2.0.
#pragma once

#include <string>
#include <vector>

#include "core/image/reader.h"

namespace lentray::views {

inline constexpr int kLongestDelay = 60'000;  ///< ms

/// One picture, which has 8 bits of sRGB.
std::string png_of(const core::StoredImage& image);

/// Samples are those of the frames; alpha is kept. `delay`: ms a frame.
std::string apng_of(const std::vector<core::StoredImage>& frames, int delay);

/// 256 colours, the same for all frames, so that what stands still does not flicker; without alpha.
/// The delay is rounded to hundredths of a second, at least 2 of them.
std::string gif_of(const std::vector<core::StoredImage>& frames, int delay);

}  // namespace lentray::views
