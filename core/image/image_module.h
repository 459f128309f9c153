// What OpenImageIO does for us, in a module of its own that is loaded when it is needed first.
// Threads: any number.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

#include "core/image/picture_encoder.h"
#include "core/image/reader.h"

namespace lentray::core {

using CheckPictureRoom = void (*)(std::uint64_t width, std::uint64_t height, int channels,
                                  int bytes);

class ImageModule {
 public:
  virtual ~ImageModule() = default;
  virtual std::unique_ptr<PictureEncoder> encoder(const std::filesystem::path& path,
                                                  const PictureSpec& spec) const = 0;
  /// `named`: what the file is called, for `path` may be only a handle on it.
  /// Errors: std::runtime_error with the reason alone.
  /// `check_room`: check_picture_room() (core/image/format_readers.h), which the module cannot see.
  virtual StoredImage read(const std::filesystem::path& path, const std::filesystem::path& named,
                           CheckPictureRoom check_room) const = 0;
  /// Of the bytes of a TIFF file. Errors: as read().
  virtual StoredImage read_tiff(const std::string& file, CheckPictureRoom check_room) const = 0;
};

/// Loads it. Errors: ImageError if it is not beside the program.
const ImageModule& image_module();

}  // namespace lentray::core
