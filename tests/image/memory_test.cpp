// Pictures larger than the memory that is given: only bands of rows are held.
#include <gtest/gtest.h>
#include <zlib.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/support/render.h"

namespace lentray::test {
namespace {

constexpr const char* kMemoryScene = R"(#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0,1.5,-6> look_at <0,0.8,0> angle 40 }
light_source { <-5,8,-6> rgb 1 }
background { rgb <0.3,0.5,0.8> }
plane { y, 0 pigment { checker rgb 0.9 rgb 0.3 } }
sphere { <-1,1,0>, 1 pigment { rgb <0.9,0.2,0.2> } finish { phong 0.6 } }
sphere { <1.1,0.6,-1>, 0.6 pigment { rgb <0.2,0.3,0.9> } finish { reflection 0.3 } }
)";

constexpr double kMiB = 1024.0 * 1024.0;

/// Renders the scene and returns the statistics; width and height are those of the PNG's header.
nlohmann::json statistics(std::vector<std::string> arguments, double seconds = 300.0) {
  const tool::TemporaryFolder folder;
  tool::write_text(folder / "scene.pov", kMemoryScene);
  arguments.insert(arguments.end(), {"scene.pov", "-V", "Statistics_File=s.json"});
  const tool::RunResult result = run_lentray(arguments, folder.path(), seconds);
  EXPECT_EQ(result.status, 0) << result.output;
  const auto json = nlohmann::json::parse(tool::read_text(folder / "s.json"));
  std::ifstream picture(folder / "scene.png", std::ios::binary);
  unsigned char header[24] = {};
  picture.read(reinterpret_cast<char*>(header), sizeof header);
  const auto number = [&](int at) {
    return header[at] << 24 | header[at + 1] << 16 | header[at + 2] << 8 | header[at + 3];
  };
  EXPECT_EQ(number(16), json["image"]["width"]);
  EXPECT_EQ(number(20), json["image"]["height"]);
  return json;
}

TEST(ImageMemory, APictureIsNotHeldAsAWhole) {
  // 16 bytes a pixel would be 137 MiB.
  const auto json = statistics({"+W3000", "+H3000"});
  EXPECT_LT(json["memory"]["peak_bytes"], 100 * kMiB);
  EXPECT_GT(json["bands"]["count"], 4);
  EXPECT_EQ(json["rays"]["camera"], 9000000);
}

TEST(ImageMemory, MaxMemoryIsKept) {
  const auto plenty = statistics({"+W2400", "+H1800", "Pixel_Order=views", "Lenticular=On"});
  EXPECT_EQ(plenty["bands"]["count"], 1);
  EXPECT_EQ(plenty["bands"]["height"], 1800);
  const double base = plenty["memory"]["peak_bytes"].get<double>() - 2400.0 * 1800 * 16;
  const double limit = base + 40 * kMiB;
  const auto json = statistics({"+W2400", "+H1800", "Pixel_Order=views", "Lenticular=On",
                                "Max_Memory=" + std::to_string(static_cast<long>(limit))});
  EXPECT_GT(json["bands"]["count"], 1);
  EXPECT_LT(json["memory"]["peak_bytes"], limit);
}

TEST(ImageMemory, TooLittleIsSaid) {
  const tool::TemporaryFolder folder;
  tool::write_text(folder / "scene.pov", kMemoryScene);
  const auto result = run_lentray(
      {"scene.pov", "+W40", "+H30", "Max_Memory=1M", "Statistics_File=s.json"}, folder.path());
  EXPECT_EQ(result.status, 1);
  EXPECT_NE(result.output.find("Max_Memory is less than the scene and a row of the picture take"),
            std::string::npos)
      << result.output;
  EXPECT_FALSE(std::filesystem::exists(folder / "scene.png"));
}

/// The head of a picture of 20,000 x 20,000 alone: nothing more is to be read.
std::string large_png() {
  std::string file("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\x4e\x20\0\0\x4e\x20\x8\x2\0\0\0", 29);
  const auto sum = crc32(0, reinterpret_cast<const Bytef*>(file.data() + 12), 17);
  for (const int shift : {24, 16, 8, 0}) file += static_cast<char>(sum >> shift & 255);
  return file + std::string("\0\0\0\0IDAT\x35\xaf\x06\x1e", 12);
}

/// Whatever is large and has its size in the scene is asked about first, at its place.
TEST(ImageMemory, WhatIsTooLargeIsNotBegun) {
  for (const std::string text :
       {"#declare A = array[50000000];",
        "sphere { 0, 1 pigment { image_map { function 9000, 9000 { x } } } }",
        "height_field { function 9900, 9900 { x } }",
        "plane { y, 0 pigment { image_map { png \"large.png\" } } }"}) {
    const tool::TemporaryFolder folder;
    tool::write_text(folder / "large.png", large_png());
    tool::write_text(folder / "scene.pov",
                     "#version 3.7; global_settings { assumed_gamma 1 }\n" + text + "\n");
    const auto result =
        run_lentray({"scene.pov", "+W40", "+H30", "Max_Memory=200M"}, folder.path());
    EXPECT_EQ(result.status, 1) << text << result.output;
    EXPECT_NE(result.output.find("(Max_Memory)"), std::string::npos) << text << result.output;
    EXPECT_NE(result.output.find("scene.pov:2:"), std::string::npos) << text << result.output;
  }
}

/// What grows bit by bit is ended when it has grown too large.
TEST(ImageMemory, WhatGrowsIsStopped) {
  for (const std::string text : {"union { #while (1) sphere { 0, 1 } #end }",
                                 "mesh { #declare I = 0; #while (1) triangle { <I, 0, 0>, x, <0, "
                                 "1, I> } #declare I = I + 1; #end }"}) {
    const tool::TemporaryFolder folder;
    tool::write_text(folder / "scene.pov",
                     "#version 3.7; global_settings { assumed_gamma 1 }\n" + text + "\n");
    tool::write_text(folder / "scene.png", "an older picture");
    const auto result =
        run_lentray({"scene.pov", "+W40", "+H30", "Max_Memory=200M"}, folder.path());
    EXPECT_EQ(result.status, 1) << text << result.output;
    EXPECT_NE(result.output.find("(Max_Memory): 210 MB"), std::string::npos)
        << text << result.output;
    EXPECT_EQ(tool::read_text(folder / "scene.png"), "an older picture");
  }
}

/// Who is the memory's: each kind is named.
TEST(ImageMemory, KindsAreNamed) {
  const auto json = statistics({"+W64", "+H48"});
  const auto& stages = json["memory"]["stages"];
  for (const char* kind : {"tokens", "descriptions", "pictures", "textures", "objects", "hierarchy",
                           "light_buffers", "film"})
    EXPECT_TRUE(stages.contains(kind)) << kind;
  EXPECT_GT(stages["textures"], 100);
  EXPECT_LT(stages["textures"], 100'000);
  EXPECT_GE(stages["film"], 64 * 48 * 16);
}

/// A print of 20 inches at 1200 dots an inch, with all defaults.
TEST(SlowMemory, ALargePrintFitsIntoTwoGiB) {
  const auto json = statistics({"+W24000", "+H24000", "Lenticular=On", "Print_DPI=1200"}, 3500.0);
  EXPECT_EQ(json["rays"]["camera"], 576000000);
  EXPECT_LT(json["memory"]["peak_bytes"], 2048 * kMiB);
  RecordProperty("peak_bytes", json["memory"]["peak_bytes"].dump());
}

}  // namespace
}  // namespace lentray::test
