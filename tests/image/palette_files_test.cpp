// Pictures of few bits against stock: palettes of TARGA, BMP and GIF files, whose entries are the heights of
// height fields, and TARGA files of five bits a colour.
#include <gtest/gtest.h>

#include <string>

#include "tests/support/render.h"

namespace lentray::test {
namespace {

constexpr int kSide = 12, kEntries = 16;

int entry(int pixel) { return (pixel % kSide * 3 + pixel / kSide * 7) % kEntries; }

std::string word(int value) {
  return {static_cast<char>(value & 255), static_cast<char>(value >> 8 & 255)};
}

std::string bytes(std::initializer_list<int> values) {
  std::string all;
  for (const int value : values) all += static_cast<char>(value);
  return all;
}

/// Blue, green, red.
std::string colour(int i) { return bytes({(i * 97 + 7) % 256, (i * 31 + 90) % 256, (i * 53 + 20) % 256}); }
std::string five_bits(int i) {
  return word(0x8000 | (i * 7 + 3) % 32 << 10 | (i * 5 + 11) % 32 << 5 | (i * 3 + 1) % 32);
}

template <class Each>
std::string repeated(int count, Each&& each) {
  std::string all;
  for (int i = 0; i < count; ++i) all += each(i);
  return all;
}

std::string pixels() {
  return repeated(kSide * kSide, [](int i) { return bytes({entry(i)}); });
}

std::string targa_head(int type, int entry_bits, int bits, int alpha_bits) {
  const int entries = entry_bits > 0 ? kEntries : 0;
  return bytes({0, entries > 0 ? 1 : 0, type, 0, 0}) + word(entries) + bytes({entry_bits, 0, 0, 0, 0}) +
         word(kSide) + word(kSide) + bytes({bits, 0x20 | alpha_bits});
}

std::string file(const std::string& name) {
  const auto rows = [](auto&& head) {
    return repeated(kSide, [&](int y) { return head + pixels().substr(static_cast<std::size_t>(y) * kSide, kSide); });
  };
  if (name == "palette.tga") return targa_head(1, 24, 8, 0) + repeated(kEntries, colour) + pixels();
  if (name == "packed.tga") return targa_head(9, 24, 8, 0) + repeated(kEntries, colour) + rows(bytes({kSide - 1}));
  if (name == "palette16.tga") return targa_head(1, 16, 8, 0) + repeated(kEntries, five_bits) + pixels();
  if (name == "colours16.tga") {
    return targa_head(2, 0, 16, 1) + repeated(kSide * kSide, [](int i) { return five_bits(entry(i)); });
  }
  if (name == "greys.tga") {
    return targa_head(3, 0, 8, 0) + repeated(kSide * kSide, [](int i) { return bytes({entry(i) * 16}); });
  }
  constexpr int kStart = 54 + 4 * kEntries;
  return "BM" + word(kStart + kSide * kSide) + word(0) + word(0) + word(0) + word(kStart) + word(0) +
         word(40) + word(0) + word(kSide) + word(0) + word(kSide) + word(0) + word(1) + word(8) +
         word(0) + word(0) + word(kSide * kSide) + std::string(10, '\0') + word(kEntries) + std::string(6, '\0') +
         repeated(kEntries, [](int i) { return colour(i) + std::string(1, '\0'); }) + pixels();
}

class ImagePaletteFiles : public ::testing::TestWithParam<const char*> {};

TEST_P(ImagePaletteFiles, HeightsAndColours) {
  const std::string name = GetParam(), type = name.substr(name.size() - 3);
  const std::string sdl =
      "#version 3.7; global_settings { assumed_gamma 1 } camera { location <0,3,-3> look_at 0 angle 60 }\n"
      "light_source { <-4,7,-6>, 1 }\n"
      "height_field { " + type + " \"" + name + "\" scale <2.4,1,2.4> translate <-1.8,-.6,-1.2> pigment { rgb 1 } }\n"
      "plane { z, 1.5 pigment { image_map { " + type + " \"" + name + "\" } scale 1.5 } finish { ambient 1 diffuse 0 } }";
  EXPECT_TRUE(same_as_stock({.sdl = sdl, .width = 96, .height = 72, .arguments = {}, .files = {{name, file(name)}}}));
}

INSTANTIATE_TEST_SUITE_P(Each, ImagePaletteFiles,
                         ::testing::Values("palette.tga", "packed.tga", "palette16.tga", "colours16.tga", "greys.tga",
                                           "palette.bmp"),
                         [](const auto& one) {
                           std::string name = one.param;
                           name[name.find('.')] = '_';
                           return name;
                         });

}  // namespace
}  // namespace lentray::test
