// A whole picture to a file.
#pragma once

#include <filesystem>

#include "core/image/writer.h"

namespace lentray::core {

inline void write_image(const Image& image, const std::filesystem::path& path,
                        const ImageFormat& format, const ImageMetadata& metadata = {}) {
  PictureWriter writer(path, image.width, image.height, format, metadata);
  writer.put(image);
  writer.finish();
}

}  // namespace lentray::core
