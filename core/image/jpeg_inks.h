// JPEG files for printing presses: the four inks as they are stored. read_image() makes colours of them by a rule that
// knows no press. Errors: ImageError. Threads: any number.
#pragma once

#include <filesystem>

#include "core/image/reader.h"

namespace lentray::core {

/// Four channels of 8 bits, cyan, magenta, yellow and black: 0 is paper, 255 all of the ink.
StoredImage read_jpeg_inks(const std::filesystem::path& path);

}  // namespace lentray::core
