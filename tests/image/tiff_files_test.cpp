// TIFF files as pictures and heights against stock: greys, colours and palettes of 8 and 16 bits, with and
// without alpha, which colours may be multiplied by; entries of palettes by their number.
#include <gtest/gtest.h>

#include <cstddef>
#include <iterator>
#include <string>
#include <vector>

#include "tests/image/picture_values.h"

namespace lentray::test {
namespace {

constexpr int kTiffFilesWidth = kValueColumns, kHeight = 2;

enum Alpha { kUnspecified = 0, kMultiplied = 1, kApart = 2, kNone = 9 };
enum Meaning { kWhiteIsZero = 0, kBlackIsZero = 1, kColours = 2, kPalette = 3 };

struct Tiff {
  const char* name;
  Meaning meaning;
  int bits;
  Alpha alpha;
  unsigned palette = 257;  ///< what its entries' bytes are multiplied by
};

std::string little(unsigned value, int bytes) {
  std::string all;
  for (int i = 0; i < bytes; ++i) all += static_cast<char>(value >> 8 * i & 255);
  return all;
}

unsigned tiff_files_sample(int pixel, int channel) {
  constexpr unsigned kStart[] = {5, 30, 200}, kStep[] = {37, 61, 97};
  const auto i = static_cast<std::size_t>(channel);
  return (kStart[i] + kStep[i] * static_cast<unsigned>(pixel)) % 256;
}

std::string tiff_files_pixels(const Tiff& tiff, int channels) {
  constexpr unsigned kAlpha[] = {0, 70, 81, 100, 128, 200, 254, 255};
  std::string all;
  for (int pixel = 0; pixel < kTiffFilesWidth * kHeight; ++pixel) {
    for (int c = 0; c < channels; ++c) {
      const unsigned high = tiff_files_sample(pixel, c), low = tiff_files_sample(pixel, 1);
      all += tiff.bits == 16
                 ? little(high * 256 + low, 2)
                 : little(tiff.meaning == kPalette ? static_cast<unsigned>(pixel) : high, 1);
    }
    if (tiff.alpha == kNone) continue;
    const unsigned alpha = kAlpha[pixel % 8];
    all += tiff.bits == 16 ? little(alpha * 257, 2) : little(alpha, 1);
  }
  return all;
}

std::string palette(unsigned times) {
  std::string all;
  for (int c = 0; c < 3; ++c) {
    for (int i = 0; i < 256; ++i) all += little(tiff_files_sample(i, c) * times, 2);
  }
  return all;
}

/// Entries of the directory whose values do not fit are put behind it, the pixels at last.
std::string tiff_files_file(const Tiff& tiff) {
  const int channels = tiff.meaning == kColours ? 3 : 1,
            all_channels = channels + (tiff.alpha == kNone ? 0 : 1);
  const std::string image = tiff_files_pixels(tiff, channels);
  const unsigned entries = 9 + (tiff.meaning == kPalette ? 1 : 0) + (tiff.alpha == kNone ? 0 : 1);
  const unsigned behind = 8 + 2 + 12 * entries + 4;
  std::string directory, values;
  const auto add = [&](unsigned tag, unsigned bytes, unsigned count, const std::string& value) {
    directory += little(tag, 2) + little(bytes == 2 ? 3 : 4, 2) + little(count, 4);
    if (value.size() <= 4) {
      directory += value + std::string(4 - value.size(), '\0');
    } else {
      directory += little(behind + static_cast<unsigned>(values.size()), 4);
      values += value;
    }
  };
  std::string bits;
  for (int i = 0; i < all_channels; ++i) bits += little(static_cast<unsigned>(tiff.bits), 2);
  const unsigned start = behind + (bits.size() > 4 ? static_cast<unsigned>(bits.size()) : 0) +
                         (tiff.meaning == kPalette ? 6 * 256 : 0);
  add(256, 4, 1, little(kTiffFilesWidth, 4));
  add(257, 4, 1, little(kHeight, 4));
  add(258, 2, static_cast<unsigned>(all_channels), bits);
  add(259, 2, 1, little(1, 2));  // not packed
  add(262, 2, 1, little(tiff.meaning, 2));
  add(273, 4, 1, little(start, 4));
  add(277, 2, 1, little(static_cast<unsigned>(all_channels), 2));
  add(278, 4, 1, little(kHeight, 4));
  add(279, 4, 1, little(static_cast<unsigned>(image.size()), 4));
  if (tiff.meaning == kPalette) add(320, 2, 3 * 256, palette(tiff.palette));
  if (tiff.alpha != kNone) add(338, 2, 1, little(tiff.alpha, 2));
  return std::string("II*\0\x08\0\0\0", 8) + little(entries, 2) + directory + little(0, 4) +
         values + image;
}

const Tiff kTiffs[] = {{"Grey", kBlackIsZero, 8, kNone},
                       {"GreyFromWhite", kWhiteIsZero, 8, kNone},
                       {"DeepGrey", kBlackIsZero, 16, kNone},
                       {"DeepGreyFromWhite", kWhiteIsZero, 16, kNone},
                       {"GreyAlpha", kBlackIsZero, 8, kApart},
                       {"GreyMultiplied", kBlackIsZero, 8, kMultiplied},
                       {"DeepGreyAlpha", kBlackIsZero, 16, kApart},
                       {"Colours", kColours, 8, kNone},
                       {"DeepColours", kColours, 16, kNone},
                       {"Alpha", kColours, 8, kApart},
                       {"Multiplied", kColours, 8, kMultiplied},
                       {"OfSomeKind", kColours, 8, kUnspecified},
                       {"DeepAlpha", kColours, 16, kApart},
                       {"DeepMultiplied", kColours, 16, kMultiplied},
                       {"Palette", kPalette, 8, kNone},
                       {"DeepPalette", kPalette, 8, kNone, 251},
                       {"PaletteOfBytes", kPalette, 8, kNone, 1}};

/// "Grey.tif", and so on.
std::string tiff_files_name(const Tiff& tiff) { return std::string(tiff.name) + ".tif"; }

Files tiff_files_all() {
  Files files;
  for (const Tiff& tiff : kTiffs) files.emplace_back(tiff_files_name(tiff), tiff_files_file(tiff));
  return files;
}

/// What follows is of this file: a word that expect_same_values() tells.
std::string tiff_files_about(const Tiff& tiff) {
  return "#write(OUT, \"of_" + std::string(tiff.name) + "\\n\")\n";
}

/// All files in one scene, for programs take longer to start with TIFF than to read these.
TEST(ImageTiffFiles, Values) {
  for (const std::string gamma : {"1", "2.2"}) {
    std::string sdl = "#version 3.7; global_settings { assumed_gamma " + gamma + " }" + kOpenValues;
    int number = 0;
    for (const Tiff& tiff : kTiffs) {
      const std::string image = "tiff \"" + tiff_files_name(tiff) + "\"";
      sdl += tiff_files_about(tiff);
      for (const char* words : {"", " gamma 1.6", " premultiplied on", " premultiplied off"}) {
        sdl += picture_values(image + words, number++);
      }
      sdl += values("pattern { image_pattern { " + image + " use_alpha } }",
                    "A" + std::to_string(number), "str(C, 0, 9)");
    }
    expect_same_values(sdl, tiff_files_all());
  }
}

class ImageTiffHeights : public ::testing::TestWithParam<Tiff> {};

TEST_P(ImageTiffHeights, AsStock) {
  const std::string sdl =
      "#version 3.7; global_settings { assumed_gamma 1 } camera { location <0,2,-1.5> look_at 0 "
      "angle 60 }\n"
      "light_source { <-3,4,-5>, 1 } height_field { tiff \"a.tif\" translate <-.5,0,-.5> scale 2 "
      "pigment { rgb 1 } }";
  EXPECT_TRUE(same_as_stock({.sdl = sdl,
                             .width = 80,
                             .height = 60,
                             .arguments = {},
                             .files = {{"a.tif", tiff_files_file(GetParam())}}}));
}

/// Colours are divided by their alpha once pixels are mixed, with the transparency that the map gives them.
TEST(ImageTiffFiles, MixedAndMadeClearer) {
  std::string sdl = std::string("#version 3.7; global_settings { assumed_gamma 1 }") + kOpenValues;
  int number = 0;
  for (const Tiff& tiff : kTiffs) {
    sdl += tiff_files_about(tiff);
    for (const char* words :
         {"interpolate 2", "premultiplied off interpolate 2", "transmit all .3",
          "filter all .3 transmit all 1", "interpolate 3 transmit all .1 filter all .2",
          "premultiplied off transmit all .3"}) {
      sdl += values("pigment { image_map { tiff \"" + tiff_files_name(tiff) + "\" " + words +
                        " } translate .03*x }",
                    "C" + std::to_string(number++), "vstr(5, C, \" \", 0, 9)");
    }
  }
  expect_same_values(sdl, tiff_files_all());
}

std::string palette_file() { return tiff_files_file(kTiffs[std::size(kTiffs) - 2]); }

TEST(ImageTiffPalettes, EntriesByNumber) {
  std::string sdl =
      "#version 3.7; global_settings { assumed_gamma 1 } camera { location -3*z look_at 0 angle 50 "
      "}\n"
      "#default { finish { ambient .6 diffuse .4 } } plane { z, 3 pigment { checker rgb 1 rgb x "
      "scale .3 } finish { ambient 1 diffuse 0 } }\n";
  int column = 0;
  for (const char* looks :
       {"pigment { image_map { tiff \"a.tif\" transmit 3, .6 filter 5, .8 filter all .2 filter 6, "
        ".9 } }",
        "pigment { image_map { tiff \"a.tif\" transmit all .5 transmit 4, .1 interpolate 2 } }",
        "pigment { image_pattern { tiff \"a.tif\" use_alpha } color_map { [0 rgb y] [1 rgb z] } }",
        "texture { material_map { tiff \"a.tif\" texture { pigment { rgb x } } texture { pigment { "
        "rgb y } }"
        " texture { pigment { rgb z } } } }",
        "pigment { rgb 1 } normal { bump_map { tiff \"a.tif\" use_index bump_size 2 } scale .5 "
        "}"}) {
    const std::string left = std::to_string(-1.3 + 0.55 * column++);
    sdl += "box { <" + left + ",-1,0>, <" + left + "+.5,1,.1> " + looks + " }\n";
  }
  sdl += "light_source { <-3,4,-5>, 1 }";
  EXPECT_TRUE(same_as_stock({.sdl = sdl,
                             .width = 96,
                             .height = 48,
                             .arguments = {},
                             .files = {{"a.tif", palette_file()}}}));
}

TEST(ImageTiffPalettes, EntriesThatAreNotThere) {
  const tool::TemporaryFolder folder;
  tool::write_text(folder / "a.tif", palette_file());
  for (const bool is_there : {true, false}) {
    tool::write_text(folder / "scene.pov",
                     "#version 3.7; global_settings { assumed_gamma 1 }\nsphere { 0, 1 pigment { "
                     "image_map { tiff \"a.tif\"\n filter " +
                         std::string(is_there ? "255" : "256") + ", .5 } } }\n");
    const std::vector<std::string> arguments{"+Iscene.pov", "+Oa.png", "+W4", "+H3", "-D"};
    std::vector<std::string> stock_arguments{"povray"};
    stock_arguments.insert(stock_arguments.end(), arguments.begin(), arguments.end());
    EXPECT_EQ(tool::run_program(stock_arguments, folder.path(), 60.0).status == 0, is_there);
    const tool::RunResult ours = run_lentray(arguments, folder.path());
    EXPECT_EQ(ours.status, is_there ? 0 : 1) << ours.output;
    EXPECT_EQ(ours.output.find("scene.pov:3:9: error: expected an entry of the palette") ==
                  std::string::npos,
              is_there)
        << ours.output;
  }
}

INSTANTIATE_TEST_SUITE_P(Each, ImageTiffHeights, ::testing::ValuesIn(kTiffs),
                         [](const auto& one) { return std::string(one.param.name); });

}  // namespace
}  // namespace lentray::test
