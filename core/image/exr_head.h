// What OpenEXR makes room for as soon as it opens a file: its head's attributes and the rows of its window.
// Errors: std::runtime_error. Threads: any number. Source: the format's description, "Header".
#pragma once

#include <cstdint>
#include <string_view>

namespace lentray::core {

struct ExrWindow {
  std::uint64_t width = 0, height = 0;
};

/// Of a file of `bytes` that begins so. Throws where an attribute is longer than the file. 0 x 0: the window lies
/// beyond what is given.
ExrWindow exr_window(std::string_view begin, std::uint64_t bytes);

}  // namespace lentray::core
