// TIFF files as stock sees them: of 8 bits a value but for palettes, and colours multiplied by their alpha.
// Source: reference manual 3.7, "Image Map"; compared with stock by tests/image/tiff_files_test.cpp.
#pragma once

#include <filesystem>

#include "core/image/reader.h"

namespace lentray::parser {

/// `path`: of the file it was read from.
void make_tiff_bytes(core::StoredImage& image, const std::filesystem::path& path);
bool has_tiff_palette(const core::StoredImage& image);

}  // namespace lentray::parser
