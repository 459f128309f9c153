// Pictures rearranged pixel by pixel: no sample is changed but where a function says so.
// Errors: core::NoRoom (core/base/memory_limit.h) where memory does not hold the result. Pure.
#pragma once

#include <cstdint>
#include <vector>

#include "core/image/reader.h"
#include "core/numeric/lens_columns.h"
#include "tools/lentray-print/page.h"

namespace lentray::print {

/// Grey or RGB of `bits` 8 or 16: alpha is laid over the background, floats become sRGB's values.
core::StoredImage as_printed(core::StoredImage image, int bits, Colour background);

/// The columns of an integral image that stand for columns `first` .. `first + count - 1`, which may lie beyond its
/// edges: there each view continues with its outermost pixel, the one at the same place behind the nearest lens.
/// `width`: the image's columns, whole lenses.
std::vector<std::uint32_t> continued_columns(std::int64_t first, std::uint32_t count,
                                             std::uint32_t width, const core::LensColumns& lenses);
/// Rows beyond the edges are the outermost ones.
std::vector<std::uint32_t> continued_rows(std::int64_t first, std::uint32_t count,
                                          std::uint32_t height);

/// The image without what lies behind a last lens that is cut.
core::StoredImage of_whole_lenses(core::StoredImage image, double lens_pixels);

}  // namespace lentray::print
