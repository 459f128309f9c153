// Pictures in memory as their files store them, the light that they stand for, and files of the
// same samples with what is known of the lens sheet.
// Errors: core::ImageError, worded for the user. Threads: any number.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/image/reader.h"
#include "tools/common/sheet_facts.h"

namespace lentray::views {

using tool::Facts;
using tool::facts_of;
/// `about`, for messages: a number that the facts hold; 0 without it. Throws if it is no number.
double number_in(const Facts& facts, const std::string& name, const std::string& about);

/// Black, of that size, with the samples and colours of `like` and nothing said of it.
core::StoredImage blank_like(const core::StoredImage& like, std::uint32_t width,
                             std::uint32_t height);
/// A rectangle of pixels, all of it inside both pictures, which are of one kind.
struct Rectangle {
  std::uint32_t left = 0, top = 0, width = 0, height = 0;
};
void copy_pixels(const core::StoredImage& from, const Rectangle& what, core::StoredImage& to,
                 std::uint32_t left, std::uint32_t top);
/// Why pictures cannot be put together: "640 x 480 and 640 x 400 pixels"; empty: they can.
std::string other_kind(const core::StoredImage& a, const core::StoredImage& b);

/// Light: 1 is white. Premultiplied by alpha where there is one.
struct Light {
  std::uint32_t width = 0, height = 0;
  int channels = 0;  ///< 1 grey, 2 with alpha, 3 RGB, 4 RGBA
  std::vector<float> values;
  const float* pixel(std::uint32_t column, std::uint32_t row) const {
    return values.data() + (std::size_t{row} * width + column) * static_cast<std::size_t>(channels);
  }
  float* pixel(std::uint32_t column, std::uint32_t row) {
    return values.data() + (std::size_t{row} * width + column) * static_cast<std::size_t>(channels);
  }
};
/// Files that say nothing of their values are taken for sRGB.
Light light_of(const core::StoredImage& image);
/// In samples like those of `like`, whose channels may be others.
core::StoredImage stored(const Light& light, const core::StoredImage& like);
/// 8 bits of sRGB, for viewers.
core::StoredImage for_viewers(const core::StoredImage& image);
core::StoredImage for_viewers(const Light& light);

/// What goes into a file besides its pixels.
struct About {
  Facts facts;                      ///< as "lentray:" and the name
  std::string description;          ///< empty: none
  double dpi_x = 0.0, dpi_y = 0.0;  ///< 0: no resolution
  int orientation = 1;              ///< how the file's pixels are to be turned to stand upright
};
/// PNG, TIFF, OpenEXR or JPEG by the name's extension. Samples are written as they are where the
/// file takes them; the file appears whole or not at all.
void write_picture(const core::StoredImage& image, const std::filesystem::path& path,
                   const About& about);

}  // namespace lentray::views
