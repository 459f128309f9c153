// Pictures made small, for pages that show many of them, and coded as JPEG in memory.
//
// Light is averaged over areas, as the file's gamma says it is stored; what is transparent stands before a
// checkerboard of greys. Units: pixels; samples of 8 bits, with sRGB's curve. Space: row 0 on top.
// Besides the picture, memory holds one row of it and the result. Errors: std::invalid_argument where a size is 0;
// std::runtime_error from libjpeg. Threads: any number. Source: docs/lens.md for the columns of a view.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/image/reader.h"

namespace lentray::core {

struct Thumbnail {
  std::uint32_t width = 0, height = 0;
  std::vector<std::uint8_t> rgb;
};

struct ThumbnailSize {
  std::uint32_t width = 0, height = 0;
};

/// The whole picture. The size may have other proportions, and may be larger.
Thumbnail thumbnail_of(const StoredImage& image, ThumbnailSize size);

/// Views of an integral image, one for each of `views`: 0 is the first column of each lens, and parts between two
/// columns are the nearer one. `lens_pixels`: N, at least 1, may be fractional.
std::vector<Thumbnail> view_thumbnails(const StoredImage& image, double lens_pixels,
                                       const std::vector<double>& views, ThumbnailSize size);

/// The column of each lens that shows a view: nearest to view + N i, of a picture `width` pixels wide. Where the last
/// lens is cut it is left out, so that all views show the same lenses.
std::vector<std::uint32_t> view_columns(std::uint32_t width, double lens_pixels, double view);

/// Turned as StoredImages are (core/image/orientation.h): 1 or kTurned.
Thumbnail upright(Thumbnail thumbnail, int orientation);

/// One below the other; all have one size.
Thumbnail stacked(const std::vector<Thumbnail>& thumbnails);

/// Quality 1 to 100. Where the picture is narrow, colours keep their full resolution.
std::string jpeg_of(const Thumbnail& thumbnail, int quality);

}  // namespace lentray::core
