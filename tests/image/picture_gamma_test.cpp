// What becomes of the values of pictures, and of srgb colours, under each #version and assumed_gamma that stands
// before them, against stock: as numbers, so that a step of 8 bits hides nothing.
#include <gtest/gtest.h>
#include <zlib.h>

#include <string>
#include <utility>
#include <vector>

#include "tests/image/picture_values.h"

namespace lentray::test {
namespace {

constexpr int kPictureGammaWidth = kValueColumns;

int sample(int column, int channel) {
  constexpr int kStart[] = {5, 30, 200, 90}, kStep[] = {37, 61, 97, 23};
  return (kStart[channel] + kStep[channel] * column) % 256;
}

std::string picture_gamma_row(int channels) {
  std::string all;
  for (int i = 0; i < kPictureGammaWidth; ++i) {
    for (int c = 0; c < channels; ++c) all += static_cast<char>(sample(i, c));
  }
  return all;
}

std::string big(uLong value) {
  std::string all;
  for (int shift = 24; shift >= 0; shift -= 8) all += static_cast<char>(value >> shift & 255);
  return all;
}

std::string picture_gamma_chunk(const std::string& body) {
  return big(body.size() - 4) + body +
         big(crc32(0, reinterpret_cast<const Bytef*>(body.data()), uInt(body.size())));
}

/// `kind`: 0 grey, 2 colours, 6 with alpha.
std::string picture_gamma_png(char kind, int channels, const std::string& says) {
  const std::string rows = std::string(1, '\0') + picture_gamma_row(channels);
  uLongf size = compressBound(rows.size());
  std::string packed(size, '\0');
  compress(reinterpret_cast<Bytef*>(packed.data()), &size,
           reinterpret_cast<const Bytef*>(rows.data()), rows.size());
  return "\x89PNG\r\n\x1a\n" +
         picture_gamma_chunk("IHDR" + big(kPictureGammaWidth) + big(1) +
                             std::string{8, kind, 0, 0, 0}) +
         says + picture_gamma_chunk("IDAT" + packed.substr(0, size)) + picture_gamma_chunk("IEND");
}

std::string gama(uLong hundred_thousandths) {
  return picture_gamma_chunk("gAMA" + big(hundred_thousandths));
}
std::string says_srgb() { return picture_gamma_chunk(std::string("sRGB") + '\0'); }

Files files() {
  return {{"plain.png", picture_gamma_png(2, 3, "")},
          {"srgb.png", picture_gamma_png(2, 3, says_srgb())},
          {"gama.png", picture_gamma_png(2, 3, gama(60000))},
          {"both.png", picture_gamma_png(2, 3, gama(60000) + says_srgb())},
          {"alike.png", picture_gamma_png(2, 3, gama(45455))},
          {"grey.png", picture_gamma_png(0, 1, "")},
          {"grey_gama.png", picture_gamma_png(0, 1, gama(60000))},
          {"clear.png", picture_gamma_png(6, 4, "")},
          {"colours.ppm", "P6\n8 1\n255\n" + picture_gamma_row(3)},
          {"greys.pgm", "P5\n8 1\n255\n" + picture_gamma_row(1)}};
}

std::string type_of(const std::string& name) { return name.substr(name.size() - 3); }

class ImagePictureGamma : public ::testing::TestWithParam<std::pair<const char*, const char*>> {};

TEST_P(ImagePictureGamma, Values) {
  std::string sdl = std::string(GetParam().second) + kOpenValues;
  int number = 0;
  for (const auto& [name, contents] : files()) {
    for (const char* gamma : {"", " gamma 1.6"}) {
      const std::string file = type_of(name) + " \"" + name + "\"" + gamma;
      sdl += "#write(OUT, \"" + name + "\\n\")\n";
      sdl += picture_values(file, number++);
    }
  }
  expect_same_values(sdl, files());
}

INSTANTIATE_TEST_SUITE_P(
    Each, ImagePictureGamma,
    ::testing::Values(
        std::pair("Linear", "#version 3.7; global_settings { assumed_gamma 1 }"),
        std::pair("Power", "#version 3.7; global_settings { assumed_gamma 2.2 }"),
        std::pair("OtherPower", "#version 3.7; global_settings { assumed_gamma 1.5 }"),
        std::pair("Srgb", "#version 3.7; global_settings { assumed_gamma srgb }"),
        std::pair("FirstCounts",
                  "#version 3.7; global_settings { assumed_gamma 2.2 } global_settings { "
                  "assumed_gamma 1 }"),
        std::pair("NoneSoFar", "#version 3.7;"), std::pair("NoneInOldScenes", "#version 3.6;"),
        std::pair("OldScenes", "#version 3.6; global_settings { assumed_gamma 2.2 }"),
        std::pair("OldScenesSrgb", "#version 3.6; global_settings { assumed_gamma srgb }"),
        std::pair("OldFromHereOn",
                  "#version 3.7; global_settings { assumed_gamma 1 } #version 3.6;"),
        std::pair("NewFromHereOn",
                  "#version 3.6; global_settings { assumed_gamma 1 } #version 3.7;")),
    [](const auto& one) { return std::string(one.param.first); });

TEST(ImageGammaOfColours, SrgbInEachWorkingSpace) {
  for (const std::string gamma : {"1", "1.5", "2.2", "srgb"}) {
    expect_same_values("#version 3.7; global_settings { assumed_gamma " + gamma + " }" +
                           kOpenValues +
                           "#declare C = color srgbft <.2,.5,.8,.03,.4>; #write(OUT, vstr(5, C, \" "
                           "\", 0, 9), \"\\n\")\n"
                           "#declare C = color srgb <-.2,1.5,.04>; #write(OUT, vstr(5, C, \" \", "
                           "0, 9), \"\\n\")\n",
                       {});
  }
}

TEST(ImageGammaOfColours, SrgbNeedsAssumedGamma) {
  for (const std::string version : {"3.6", "3.7"}) {
    const std::string sdl = "#version " + version + ";\n#declare C = color srgb .5;\n";
    EXPECT_TRUE(written(true, sdl, {}).starts_with("FAILED"));
    EXPECT_NE(written(false, sdl, {}).find("scene.pov:2:25: error: "), std::string::npos);
  }
}

/// Colours that were multiplied by their alpha; patterns take them as they are.
TEST(ImageGammaOfColours, Premultiplied) {
  for (const std::string gamma : {"1", "2.2"}) {
    std::string sdl = "#version 3.7; global_settings { assumed_gamma " + gamma + " }" + kOpenValues;
    int number = 0;
    for (const char* words :
         {"", " premultiplied on", " premultiplied off", " gamma 1.6 premultiplied on"}) {
      sdl += picture_values("png \"clear.png\"" + std::string(words), number++);
    }
    expect_same_values(sdl, files());
  }
}

/// What stands before assumed_gamma, and functions that make surfaces and heights.
TEST(ImagePicturesInScenes, GammaAsWhereTheyStand) {
  const std::string pigment =
      "pigment { image_map { png \"plain.png\" once interpolate 2 } scale 2 } finish { ambient 1 "
      "diffuse 0 }";
  const std::string sdl =
      "#version 3.7; #declare Early = texture { " + pigment +
      " }\n"
      "global_settings { assumed_gamma 2.2 } camera { location <0,3,-4> look_at 0 angle 50 } "
      "light_source { <-4,7,-6>, 1 }\n"
      "#declare F = function { pigment { image_map { png \"plain.png\" interpolate 2 } scale 2 } "
      "}\n"
      "plane { z, 4 texture { Early scale 1.5 } } plane { z, 3.9 texture { " +
      pigment +
      " translate -2*x } clipped_by { plane { x, 0 } } }\n"
      "isosurface { function { y - F(x,.5,0).grey } contained_by { box { <-1.9,0,-1>, <0,1,1> } } "
      "max_gradient 4 pigment { rgb .7 } }\n"
      "height_field { function 20, 20 { F(x,.5,0).grey } scale <1.5,1,1.5> pigment { rgb "
      "<.9,.7,.4> } translate <.2,0,-.8> }\n"
      "height_field { function 20, 20 { pigment { image_map { png \"plain.png\" } } } scale "
      "<1.5,1,1> pigment { rgb .8 } translate <.2,0,.8> }\n";
  for (const std::string version : {"3.7", "3.6"}) {
    std::string text = sdl;
    text.replace(text.find("3.7"), 3, version);
    EXPECT_TRUE(
        same_as_stock({.sdl = text, .width = 96, .height = 72, .arguments = {}, .files = files()}));
  }
}

}  // namespace
}  // namespace lentray::test
