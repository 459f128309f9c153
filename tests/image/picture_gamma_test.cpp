// What becomes of the values of pictures, and of srgb colours, under each #version and assumed_gamma that stands
// before them, against stock: as numbers, so that a step of 8 bits hides nothing.
#include <gtest/gtest.h>
#include <zlib.h>

#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/render.h"

namespace lentray::test {
namespace {

using Files = std::vector<std::pair<std::string, std::string>>;

constexpr int kWidth = 8;

int sample(int column, int channel) {
  constexpr int kStart[] = {5, 30, 200, 90}, kStep[] = {37, 61, 97, 23};
  return (kStart[channel] + kStep[channel] * column) % 256;
}

std::string row(int channels) {
  std::string all;
  for (int i = 0; i < kWidth; ++i) {
    for (int c = 0; c < channels; ++c) all += static_cast<char>(sample(i, c));
  }
  return all;
}

std::string big(uLong value) {
  std::string all;
  for (int shift = 24; shift >= 0; shift -= 8) all += static_cast<char>(value >> shift & 255);
  return all;
}

std::string chunk(const std::string& body) {
  return big(body.size() - 4) + body + big(crc32(0, reinterpret_cast<const Bytef*>(body.data()), uInt(body.size())));
}

/// `kind`: 0 grey, 2 colours, 6 with alpha.
std::string png(char kind, int channels, const std::string& says) {
  const std::string rows = std::string(1, '\0') + row(channels);
  uLongf size = compressBound(rows.size());
  std::string packed(size, '\0');
  compress(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(rows.data()), rows.size());
  return "\x89PNG\r\n\x1a\n" + chunk("IHDR" + big(kWidth) + big(1) + std::string{8, kind, 0, 0, 0}) + says +
         chunk("IDAT" + packed.substr(0, size)) + chunk("IEND");
}

std::string gama(uLong hundred_thousandths) { return chunk("gAMA" + big(hundred_thousandths)); }
std::string says_srgb() { return chunk(std::string("sRGB") + '\0'); }

Files files() {
  return {{"plain.png", png(2, 3, "")},           {"srgb.png", png(2, 3, says_srgb())},
          {"gama.png", png(2, 3, gama(60000))},   {"both.png", png(2, 3, gama(60000) + says_srgb())},
          {"alike.png", png(2, 3, gama(45455))},  {"grey.png", png(0, 1, "")},
          {"grey_gama.png", png(0, 1, gama(60000))}, {"clear.png", png(6, 4, "")},
          {"colours.ppm", "P6\n8 1\n255\n" + row(3)}, {"greys.pgm", "P5\n8 1\n255\n" + row(1)}};
}

std::string type_of(const std::string& name) { return name.substr(name.size() - 3); }

/// What a program writes with #write(OUT, ...), or its complaint.
std::string written(bool stock, const std::string& sdl) {
  const diff::TemporaryFolder folder;
  for (const auto& [name, contents] : files()) diff::write_text(folder / name, contents);
  diff::write_text(folder / "scene.pov", sdl);
  const diff::RunResult run =
      stock ? diff::run({"povray", "+Iscene.pov", "-F", "+W4", "+H4", "-D"}, folder.path(), 60.0)
            : run_lentray({"scene.pov", "--parse-only", "+W4", "+H4"}, folder.path());
  return run.status == 0 ? diff::read_text(folder / "values.txt") : "FAILED\n" + run.output;
}

void expect_same_text(const std::string& sdl) {
  const std::string wanted = written(true, sdl), found = written(false, sdl);
  EXPECT_FALSE(wanted.starts_with("FAILED")) << wanted;
  EXPECT_FALSE(wanted.empty());
  std::istringstream ours(found), stock(wanted);
  std::string about, word, wanted_word;
  while (stock >> wanted_word) {
    ASSERT_TRUE(ours >> word) << found;
    if (wanted_word[0] >= 'a') about = wanted_word;
    if (wanted_word == word) continue;
    EXPECT_NEAR(std::stod(word), std::stod(wanted_word), 2e-7) << about << " in " << sdl.substr(0, 90);
  }
}

std::string values(const std::string& function, int number, const std::string& value) {
  const std::string name = "F" + std::to_string(number);
  return "#declare " + name + " = function { " + function + " }\n#local I = 0; #while (I < " + std::to_string(kWidth) +
         ") #local C = " + name + "((I+.5)/" + std::to_string(kWidth) + ", .5, 0); #write(OUT, " + value +
         ", \"\\n\") #local I = I + 1; #end\n";
}

class ImagePictureGamma : public ::testing::TestWithParam<std::pair<const char*, const char*>> {};

TEST_P(ImagePictureGamma, Values) {
  std::string sdl = std::string(GetParam().second) + "\n#fopen OUT \"values.txt\" write\n";
  int number = 0;
  for (const auto& [name, contents] : files()) {
    for (const char* gamma : {"", " gamma 1.6"}) {
      const std::string file = type_of(name) + " \"" + name + "\"" + gamma;
      sdl += "#write(OUT, \"" + name + "\\n\")\n";
      sdl += values("pigment { image_map { " + file + " } }", number++, "vstr(5, C, \" \", 0, 9)");
      sdl += values("pattern { image_pattern { " + file + " } }", number++, "str(C, 0, 9)");
      sdl += values("pattern { pigment_pattern { image_map { " + file + " } } }", number++, "str(C, 0, 9)");
    }
  }
  expect_same_text(sdl);
}

INSTANTIATE_TEST_SUITE_P(
    Each, ImagePictureGamma,
    ::testing::Values(std::pair("Linear", "#version 3.7; global_settings { assumed_gamma 1 }"),
                      std::pair("Power", "#version 3.7; global_settings { assumed_gamma 2.2 }"),
                      std::pair("OtherPower", "#version 3.7; global_settings { assumed_gamma 1.5 }"),
                      std::pair("Srgb", "#version 3.7; global_settings { assumed_gamma srgb }"),
                      std::pair("FirstCounts",
                                "#version 3.7; global_settings { assumed_gamma 2.2 } global_settings { assumed_gamma 1 }"),
                      std::pair("NoneSoFar", "#version 3.7;"), std::pair("NoneInOldScenes", "#version 3.6;"),
                      std::pair("OldScenes", "#version 3.6; global_settings { assumed_gamma 2.2 }"),
                      std::pair("OldScenesSrgb", "#version 3.6; global_settings { assumed_gamma srgb }"),
                      std::pair("OldFromHereOn", "#version 3.7; global_settings { assumed_gamma 1 } #version 3.6;"),
                      std::pair("NewFromHereOn", "#version 3.6; global_settings { assumed_gamma 1 } #version 3.7;")),
    [](const auto& one) { return std::string(one.param.first); });

TEST(ImageGammaOfColours, SrgbInEachWorkingSpace) {
  for (const std::string gamma : {"1", "1.5", "2.2", "srgb"}) {
    expect_same_text("#version 3.7; global_settings { assumed_gamma " + gamma +
                     " }\n#fopen OUT \"values.txt\" write\n"
                     "#declare C = color srgbft <.2,.5,.8,.03,.4>; #write(OUT, vstr(5, C, \" \", 0, 9), \"\\n\")\n"
                     "#declare C = color srgb <-.2,1.5,.04>; #write(OUT, vstr(5, C, \" \", 0, 9), \"\\n\")\n");
  }
}

TEST(ImageGammaOfColours, SrgbNeedsAssumedGamma) {
  for (const std::string version : {"3.6", "3.7"}) {
    const std::string sdl = "#version " + version + ";\n#declare C = color srgb .5;\n";
    EXPECT_TRUE(written(true, sdl).starts_with("FAILED"));
    EXPECT_NE(written(false, sdl).find("scene.pov:2:25: error: "), std::string::npos);
  }
}

/// What stands before assumed_gamma, and functions that make surfaces and heights.
TEST(ImagePicturesInScenes, GammaAsWhereTheyStand) {
  const std::string pigment = "pigment { image_map { png \"plain.png\" once interpolate 2 } scale 2 } finish { ambient 1 diffuse 0 }";
  const std::string sdl =
      "#version 3.7; #declare Early = texture { " + pigment + " }\n"
      "global_settings { assumed_gamma 2.2 } camera { location <0,3,-4> look_at 0 angle 50 } light_source { <-4,7,-6>, 1 }\n"
      "#declare F = function { pigment { image_map { png \"plain.png\" interpolate 2 } scale 2 } }\n"
      "plane { z, 4 texture { Early scale 1.5 } } plane { z, 3.9 texture { " + pigment + " translate -2*x } clipped_by { plane { x, 0 } } }\n"
      "isosurface { function { y - F(x,.5,0).grey } contained_by { box { <-1.9,0,-1>, <0,1,1> } } max_gradient 4 pigment { rgb .7 } }\n"
      "height_field { function 20, 20 { F(x,.5,0).grey } scale <1.5,1,1.5> pigment { rgb <.9,.7,.4> } translate <.2,0,-.8> }\n"
      "height_field { function 20, 20 { pigment { image_map { png \"plain.png\" } } } scale <1.5,1,1> pigment { rgb .8 } translate <.2,0,.8> }\n";
  for (const std::string version : {"3.7", "3.6"}) {
    std::string text = sdl;
    text.replace(text.find("3.7"), 3, version);
    EXPECT_TRUE(same_as_stock({.sdl = text, .width = 96, .height = 72, .arguments = {}, .files = files()}));
  }
}

}  // namespace
}  // namespace lentray::test
