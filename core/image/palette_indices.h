// Palette entries of the pixels of PNG, GIF, TIFF, TARGA and BMP files, as stored: two entries may have one colour,
// so that pictures that were read as colours cannot tell them. Errors: none, files that cannot be read have
// no entries (core/image/reader.h complains). Threads: any number.
// Source: libpng, core/image/gif_picture.h, palette_bitmaps.h and palette_tiff.h; compared with stock by image.palette_files.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "core/image/reader.h"

namespace lentray::core {

/// Of the pixels of `stored`, which was read from the same file: rows from the top, of a GIF the first picture;
/// none if the file has no palette. TARGA files are not marked: the scene says that it is one.
std::vector<std::uint8_t> palette_entries(const StoredImage& stored, const std::filesystem::path& path,
                                          bool is_targa);

}  // namespace lentray::core
