// What OpenImageIO does for us, in a module of its own that is loaded when it is needed first.
// Threads: any number.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "core/image/picture_encoder.h"
#include "core/image/reader.h"

namespace lentray::core {

class ImageModule {
 public:
  virtual ~ImageModule() = default;
  virtual std::unique_ptr<PictureEncoder> encoder(const std::filesystem::path& path,
                                                  const PictureSpec& spec) const = 0;
  /// `named` as read_image() says; empty if `path` is no handle.
  /// Errors: std::runtime_error with the reason alone.
  virtual StoredImage read(const std::filesystem::path& path, const std::filesystem::path& named) const = 0;
  /// Of the bytes of a TIFF file. Errors: as read().
  virtual StoredImage read_tiff(const std::string& file) const = 0;
};

/// Loads it. Errors: ImageError if it is not beside the program.
const ImageModule& image_module();

}  // namespace lentray::core
