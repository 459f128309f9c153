// The first picture of a GIF file as it is stored: entries and the palette, whose transparent entry has a colour
// as well. Errors: none, files that cannot be read have no picture (core/image/reader.h complains).
// Threads: any number. Source: giflib; compared with stock by image.palette_files.
#pragma once

#include <array>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <vector>

#include "core/image/reader.h"

namespace lentray::core {

struct GifPicture {
  std::uint32_t width = 0, height = 0;
  std::vector<std::uint8_t> entries;  ///< rows from the top
  std::vector<std::array<std::uint8_t, 3>> palette;
};

GifPicture read_gif_picture(std::FILE* file);

/// Pixels that are clear get the colours of their entries back. Of files that are no GIF nothing changes.
void restore_clear_colours(StoredImage& image, const std::filesystem::path& path);

}  // namespace lentray::core
