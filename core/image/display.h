// A picture as a viewer shows it: decoded as its file says, encoded for a display (sRGB), and, where it has alpha,
// laid over a checkerboard of black and white squares.
// Errors: none. Threads: any number. Source: IEC 61966-2-1; the formats of PNG and OpenEXR.
#pragma once

#include "core/image/reader.h"

namespace lentray::core {

/// Side of the checkerboard's squares, in pixels.
inline constexpr std::uint32_t kCheckerSize = 8;

/// Whether viewers show the stored values as they are.
bool is_shown_as_stored(const StoredImage& image);

/// Colours as they are stored, without alpha.
StoredImage without_alpha(const StoredImage& image);

/// R, G, B on the scale of 8 bits, not rounded, 0 to 255.
StoredImage displayed(const StoredImage& image);

}  // namespace lentray::core
