// How reader.cpp reads the formats that need no OpenImageIO: each from an open file, at its start. Palettes are
// samples of 8 bits and entries. Errors: std::runtime_error with the reason alone. Threads: any number.
#pragma once

#include <array>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <string_view>

#include "core/image/reader.h"

namespace lentray::core {

/// By libpng. Text chunks and the resolution are attributes, by the names of OpenImageIO.
StoredImage read_png(std::FILE* file);
/// By giflib: the first picture alone. The transparent entry has alpha 0, and its colour.
StoredImage read_gif(std::FILE* file);
/// By libjpeg: greys and colours; nothing for CMYK.
std::optional<StoredImage> read_jpeg(std::FILE* file);
/// Source: Truevision's TARGA specification 2.0. Five bits a colour are the upper ones of eight.
StoredImage read_targa(std::string_view file);

/// Red, green, blue and alpha of 256 entries.
using Palette = std::array<std::uint8_t, 4 * 256>;
/// Samples of 8 bits by the entries of the pixels, in as many channels as the picture has: 3 or 4.
void fill_from_palette(StoredImage& image, const Palette& palette);

/// Throws if the allowed memory does not hold that many samples of `bytes` each.
void check_picture_room(std::uint64_t width, std::uint64_t height, int channels, int bytes);

}  // namespace lentray::core
