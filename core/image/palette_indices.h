// Palette entries of the pixels of PNG and GIF files, as stored: two entries may have one colour, so that
// pictures that were read as colours cannot tell them. Errors: none, files that cannot be read have no
// entries (core/image/reader.h complains). Threads: any number.
// Source: libpng and giflib; compared with stock by image.palette_files.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace lentray::core {

struct PaletteIndices {
  std::uint32_t width = 0, height = 0;
  std::vector<std::uint8_t> entries;  ///< row 0 on top; empty: the file has no palette
};

/// Of a GIF the first picture.
PaletteIndices read_palette_indices(const std::filesystem::path& path);

}  // namespace lentray::core
