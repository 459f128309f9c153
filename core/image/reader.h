// Pictures from files, as stored: no gamma, no premultiplication, no conversion. PNG, GIF, JPEG and TARGA are read
// here; BMP, PPM, PGM, TIFF, OpenEXR and Radiance by OpenImageIO. Errors: ImageError (core/image/writer.h), also where
// the memory that is allowed (core/base/memory_limit.h) does not hold the picture. Threads: any number.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/image/samples.h"
#include "core/image/writer.h"

namespace lentray::core {

struct PictureSpec;

struct StoredImage {
  std::uint32_t width = 0, height = 0;
  int channels = 0;  ///< 1 grey, 2 with alpha, 3 RGB, 4 RGBA
  int bits = 8;      ///< 8 or 16: integers 0 .. 2^bits - 1; 32: float
  double gamma =
      0.0;  ///< the power that makes the values linear; below 0: sRGB; 0: the file does not say
  bool premultiplied = false;  ///< by alpha
  Samples samples;             ///< row 0 on top, channels interleaved
  /// Palette entries of the pixels, row 0 on top; empty: there is no palette. Two entries may have one colour,
  /// which the samples cannot show.
  std::vector<std::uint8_t> entries;
  std::map<std::string, std::string> attributes;  ///< whatever the file says of itself, as text
  /// The ICC profile that the samples' colours are of; empty: sRGB, or what `gamma` says. read_image() leaves it empty.
  std::string profile{};

  bool has_alpha() const { return channels == 2 || channels == 4; }
  /// The sample that is white.
  float most() const { return bits == 32 ? 1.0f : static_cast<float>((1u << bits) - 1u); }
  std::size_t place(std::uint32_t column, std::uint32_t row, int channel) const {
    return (std::size_t{row} * width + column) * static_cast<std::size_t>(channels) +
           static_cast<std::size_t>(channel);
  }
  float at(std::uint32_t column, std::uint32_t row, int channel) const {
    return samples[place(column, row, channel)];
  }
  Samples::Reference at(std::uint32_t column, std::uint32_t row, int channel) {
    return samples[place(column, row, channel)];
  }
};

/// Of 8 or 16 bits, all black.
inline StoredImage black_rgb(std::uint32_t width, std::uint32_t height, int bits) {
  StoredImage out;
  out.width = width;
  out.height = height;
  out.channels = 3;
  out.bits = bits;
  out.samples.store_bits(bits, std::size_t{3} * width * height);
  return out;
}

/// What a file is called where its path is only a handle on it: its end gives the format where its first bytes do
/// not, and messages name it. `is_targa`: such files are not marked, but the scene says so.
struct NamedFile {
  std::filesystem::path path, name{};
  bool is_targa = false;
};
StoredImage read_image(const NamedFile& file);
StoredImage read_image(const std::filesystem::path& path);

/// Integer samples are written as they are (`bits` 8 or 16; PNG or TIFF by the extension).
void write_stored(const StoredImage& image, const std::filesystem::path& path);
/// The samples as the spec has them.
void write_stored(const StoredImage& image, const std::filesystem::path& path,
                  const PictureSpec& spec);

}  // namespace lentray::core
