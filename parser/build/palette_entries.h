// Which entry of a picture file's palette each pixel names: heights of height fields, and what chooses among
// textures. Internal to parser/build. Errors: none. One thread.
// Source: reference manual 3.7, "Height Field"; compared with stock by image.palette_files.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/image/reader.h"

namespace lentray::parser {

/// Rows from the top; empty if the file has no palette. In TARGA and BMP files the first of entries of one
/// colour stands for all of them.
std::vector<std::uint8_t> palette_entries(const core::StoredImage& stored, const std::string& path);

}  // namespace lentray::parser
