// Radiance files as pictures and heights against stock: their mantissas stand for the middles of their steps.
#include <gtest/gtest.h>

#include <string>

#include "tests/image/picture_values.h"

namespace lentray::test {
namespace {

constexpr int kRadianceFilesWidth = kValueColumns, kHeight = 6;

/// Not in runs. The largest mantissa of a pixel has its upper bit set;
/// the last pixel is black.
std::string radiance_files_file() {
  std::string all = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y " + std::to_string(kHeight) + " +X " +
                    std::to_string(kRadianceFilesWidth) + "\n";
  for (int i = 0; i < kRadianceFilesWidth * kHeight; ++i) {
    const bool is_black = i == kRadianceFilesWidth * kHeight - 1;
    const int mantissas[] = {128 + i * 37 % 128, i * 53 % 256, i * 91 % 256};
    for (int c = 0; c < 3; ++c) all += static_cast<char>(is_black ? 0 : mantissas[(i + c) % 3]);
    all += static_cast<char>(is_black ? 0 : 128 - i % 4);
  }
  return all;
}

TEST(ImageRadianceFiles, Values) {
  const std::string image = "hdr \"a.hdr\"";
  for (const std::string gamma : {"1", "2.2"}) {
    std::string sdl = "#version 3.7; global_settings { assumed_gamma " + gamma + " }" + kOpenValues;
    int number = 0;
    for (const char* words : {"", " gamma 1.6", " gamma srgb", " interpolate 2"})
      sdl += picture_values(image + words, number++);
    sdl += values("pattern { image_pattern { " + image + " use_alpha } }", "A", "str(C, 0, 9)");
    expect_same_values(sdl, {{"a.hdr", radiance_files_file()}});
  }
}

/// The red of colours that are not of 16 bits is the high byte.
TEST(ImageRadianceFiles, Heights) {
  const std::string sdl =
      "#version 3.7; global_settings { assumed_gamma 1 } camera { location <0,2,-1.5> look_at 0 "
      "angle 60 }\n"
      "light_source { <-3,4,-5>, 1 } height_field { hdr \"a.hdr\" translate <-.5,0,-.5> scale 2 "
      "pigment { rgb 1 } }";
  EXPECT_TRUE(same_as_stock({.sdl = sdl,
                             .width = 80,
                             .height = 60,
                             .arguments = {},
                             .files = {{"a.hdr", radiance_files_file()}}}));
}

}  // namespace
}  // namespace lentray::test
