// Height fields of every kind of file that stock reads here, made by oiiotool from the same colours: of 8 and 16
// bits and floats, grey, coloured and with alpha, with and without `gamma`.
// Palettes are in palette_files_test.cpp, the kinds of TIFF in tiff_files_test.cpp.
#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

#include "tests/support/render.h"

namespace lentray::test {
namespace {

constexpr int kWidth = 20, kDepth = 16;

/// P3: hills of red, greens that do not go with them.
std::string colours() {
  std::ostringstream text;
  text << "P3\n" << kWidth << ' ' << kDepth << "\n1000\n";
  for (int row = 0; row < kDepth; ++row) {
    for (int column = 0; column < kWidth; ++column) {
      const int red = (column * 31 + row * row * 5) % 400 + 20 * row,
                green = (column * column * 13 + row * 71) % 1000;
      text << red << ' ' << green << ' ' << (column * 97 + row * 3) % 1000 << '\n';
    }
  }
  return text.str();
}

struct Kind {
  const char* name;
  const char* type;             ///< of the scene's language
  const char* suffix;           ///< of the file
  std::vector<std::string> as;  ///< what oiiotool does with the colours
  const char* gamma = "";
};

const Kind kKinds[] = {
    {"Png", "png", "png", {"-d", "uint8"}},
    {"DeepPng", "png", "png", {"-d", "uint16"}},
    {"GreyPng", "png", "png", {"--ch", "R", "-d", "uint8"}},
    {"DeepGreyPng", "png", "png", {"--ch", "R", "-d", "uint16"}},
    {"AlphaPng", "png", "png", {"--ch", "R,G,B,A=0.5", "-d", "uint8"}},
    {"Ppm", "ppm", "ppm", {"-d", "uint8"}},
    {"DeepPpm", "ppm", "ppm", {"-d", "uint16"}},
    {"Pgm", "pgm", "pgm", {"--ch", "R", "-d", "uint8"}},
    {"DeepPgm", "pgm", "pgm", {"--ch", "R", "-d", "uint16"}},
    {"Jpeg", "jpeg", "jpg", {"-d", "uint8"}},
    {"GreyJpeg", "jpeg", "jpg", {"--ch", "R", "-d", "uint8"}},
    {"Targa", "tga", "tga", {"-d", "uint8"}},
    {"Bitmap", "bmp", "bmp", {"-d", "uint8"}},
    {"Tiff", "tiff", "tif", {"-d", "uint16"}},
    {"Exr", "exr", "exr", {"-d", "half"}},
    {"ExrOfFloats", "exr", "exr", {"-d", "float"}},
    {"ExrGamma", "exr", "exr", {"-d", "half"}, "gamma 2.2"},
    {"ExrBeyondOne", "exr", "exr", {"--mulc", "1.7", "-d", "half"}},
    {"ExrBelowNone", "exr", "exr", {"--subc", ".2", "-d", "half"}},
    {"GreyExr", "exr", "exr", {"--ch", "R", "--chnames", "Y", "-d", "half"}},
    {"AlphaExr", "exr", "exr", {"--ch", "R,G,B,A=0.5", "-d", "half"}},
};

std::string file_of(const Kind& kind) { return std::string(kind.name) + "." + kind.suffix; }

class ImageHeightKinds : public ::testing::TestWithParam<Kind> {
 protected:
  /// All files by one run, for oiiotool takes longer to start than for these.
  static void SetUpTestSuite() {
    m_folder = new tool::TemporaryFolder;
    tool::write_text(*m_folder / "colours.ppm", colours());
    std::vector<std::string> command = {"oiiotool"};
    for (const Kind& kind : kKinds) {
      command.push_back("colours.ppm");
      command.insert(command.end(), kind.as.begin(), kind.as.end());
      command.insert(command.end(), {"-o", file_of(kind)});
    }
    const tool::RunResult made = tool::run_program(command, m_folder->path(), 60.0);
    ASSERT_EQ(made.status, 0) << made.output;
  }
  static void TearDownTestSuite() {
    delete m_folder;
    m_folder = nullptr;
  }

  static inline tool::TemporaryFolder* m_folder = nullptr;
};

TEST_P(ImageHeightKinds, AsStock) {
  const Kind& kind = GetParam();
  const std::string file = file_of(kind);
  const std::string sdl =
      std::string(R"(#version 3.7; global_settings { assumed_gamma 1 }
camera { location <2.2,2.6,-4> look_at <0,.2,0> angle 45 }
light_source { <-4,7,-6>, 1 } light_source { <5,3,-2>, .3 } plane { y, -1.2 pigment { checker rgb .9 rgb .5 } }
height_field { )") +
      kind.type + " \"" + file + "\" " + kind.gamma +
      " scale <2.4,1.4,2.4> translate <-1.2,-.6,-1.2> pigment { rgb <.9,.5,.3> } }";
  EXPECT_TRUE(same_as_stock({.sdl = sdl,
                             .width = 120,
                             .height = 90,
                             .arguments = {},
                             .files = {{file, tool::read_text(*m_folder / file)}}}));
}

INSTANTIATE_TEST_SUITE_P(Each, ImageHeightKinds, ::testing::ValuesIn(kKinds),
                         [](const auto& one) { return std::string(one.param.name); });

}  // namespace
}  // namespace lentray::test
