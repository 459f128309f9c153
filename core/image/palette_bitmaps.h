// Palette entries of the pixels of BMP files, from their bytes. Errors: none, files that are
// something else, have another size or end early have no entries. Threads: any number.
// Source: Microsoft's description of bitmaps; compared with stock by tests/image/palette_files_test.cpp.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace lentray::core {

/// Of 1, 4 and 8 bits a pixel; those of 4 and 8 may be in runs.
std::vector<std::uint8_t> bitmap_entries(std::string_view file, std::uint32_t width,
                                         std::uint32_t height);

}  // namespace lentray::core
