// Pictures from files, as stored: no gamma, no premultiplication, no conversion. Formats: all
// that OpenImageIO reads. Errors: ImageError (core/image/writer.h). Threads: any number.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/image/writer.h"

namespace lentray::core {

struct StoredImage {
  std::uint32_t width = 0, height = 0;
  int channels = 0;            ///< 1 grey, 2 with alpha, 3 RGB, 4 RGBA
  int bits = 8;                ///< 8 or 16: integers 0 .. 2^bits - 1; 32: float
  double gamma = 0.0;          ///< the power that makes the values linear; below 0: sRGB; 0: the file does not say
  bool premultiplied = false;  ///< by alpha
  std::vector<float> samples;  ///< row 0 on top, channels interleaved
  std::map<std::string, std::string> attributes;  ///< whatever the file says of itself, as text

  float at(std::uint32_t column, std::uint32_t row, int channel) const {
    return samples[(std::size_t{row} * width + column) * channels + channel];
  }
  float& at(std::uint32_t column, std::uint32_t row, int channel) {
    return samples[(std::size_t{row} * width + column) * channels + channel];
  }
};

/// `named`: what the file is called, where `path` is only a handle on it; its end tells the format,
/// and messages name it. Through a handle only the formats that POV-Ray knows are read: some others
/// are lists of further files to open.
StoredImage read_image(const std::filesystem::path& path, const std::filesystem::path& named = {});

/// Integer samples are written as they are (`bits` 8 or 16; PNG or TIFF by the extension).
void write_stored(const StoredImage& image, const std::filesystem::path& path);

}  // namespace lentray::core
