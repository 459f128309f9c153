// Palettes of TIFF files: which entry a pixel has, and the entries' colours of 16 bits, of which OpenImageIO keeps
// the upper half alone. Errors: none, files that are something else or end early have no entries and stay as they
// were read (core/image/reader.h complains). Threads: any number.
// Source: TIFF specification 6.0, sections 2 and 5; compared with stock by tests/image/tiff_files_test.cpp.
#pragma once

#include <cstdint>
#include <filesystem>
#include <istream>
#include <string>
#include <vector>

#include "core/image/reader.h"

namespace lentray::core {

/// Of the first picture in the bytes of a file: rows from the top.
std::vector<std::uint8_t> tiff_entries(std::string file, std::uint32_t width, std::uint32_t height);
/// 0: there is none.
int tiff_palette_size(std::istream& file);

/// `image`, which was read from this file, gets the colours that its palette has for its entries: 16 bits.
void restore_palette_colours(StoredImage& image, const std::filesystem::path& path);

}  // namespace lentray::core
