// TIFF files as stock sees them: of 8 bits a value, and colours multiplied by their alpha.
// Source: reference manual 3.7, "Image Map"; compared with stock by image.tiff_files.
#pragma once

#include "core/image/reader.h"

namespace lentray::parser {

void make_tiff_bytes(core::StoredImage& image);
bool has_tiff_palette(const core::StoredImage& image);

}  // namespace lentray::parser
