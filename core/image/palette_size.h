// How many entries the palette of a picture file has, without its pixels. Errors: none, files that cannot be read
// have no palette. Threads: any number. Source: the formats of PNG, GIF, BMP, TIFF and TARGA; compared with stock by
// tests/image/palette_files_test.cpp.
#pragma once

#include <filesystem>

namespace lentray::core {

/// 0: the file has no palette. TARGA files are not marked: the scene says that it is one.
int palette_size(const std::filesystem::path& path, bool is_targa);

}  // namespace lentray::core
