// Text files that are written whole or not at all.
#pragma once

#include <string>

namespace lentray::tool {

/// Throws core::ImageError if it cannot be written; what stood in its place is whole then.
void write_text_file(const std::string& path, const std::string& text);

}  // namespace lentray::tool
