// Antialiased pictures against stock's, rendered live in one block (+BS larger than the picture,
// for stock's first method begins anew in each block), and parts of pictures against whole ones.
#include <gtest/gtest.h>

#include "tests/support/render.h"

namespace lentray::test {
namespace {

/// Edges of all directions, a mirror, glass, a fine pattern, a highlight and a wide dynamic range.
const char* const kEdges = R"(
camera { location <0.4,2.2,-6> look_at <0,0.7,0> angle 52 }
light_source { <3,9,-4> rgb 0.9 }
light_source { <-6,7,-2> rgb <0.3,0.4,0.6> }
plane { y, 0 pigment { checker rgb 0.9, rgb <0.2,0.3,0.5> scale 0.35 } finish { reflection 0.15 } }
sphere { <-1.5,0.8,0>, 0.8 pigment { rgb <0.9,0.4,0.2> } finish { phong 1 reflection 0.3 } }
sphere { <0.3,0.6,-1.2>, 0.6 pigment { rgb <0.8,1,0.9> filter 0.8 } interior { ior 1.4 } }
box { <1,0,-0.5>, <1.9,1.5,0.6> rotate 12*y pigment { rgb <3,2.2,1> } }
cylinder { <-0.2,0,1.5>, <0.3,2.4,1.6>, 0.04 pigment { rgb 0.05 } }
)";

SceneText scene(const std::string& head, const std::vector<std::string>& way) {
  SceneText out;
  out.sdl = head + kEdges;
  out.width = 80;
  out.height = 60;
  out.arguments = way;
  out.arguments.push_back("+BS4096");
  return out;
}

const std::string kLinear = "#version 3.7; global_settings { assumed_gamma 1 }\n";

class ImageAntialiasing : public ::testing::TestWithParam<std::tuple<int, int, const char*>> {};

TEST_P(ImageAntialiasing, WithoutJitterExact) {
  const auto& [method, depth, threshold] = GetParam();
  EXPECT_TRUE(
      same_as_stock(scene(kLinear, {"+AM" + std::to_string(method), "+R" + std::to_string(depth),
                                    std::string("+A") + threshold, "-J"})));
}
INSTANTIATE_TEST_SUITE_P(Ways, ImageAntialiasing,
                         ::testing::Combine(::testing::Values(1, 2), ::testing::Values(1, 2, 3, 5),
                                            ::testing::Values("0.0", "0.1", "0.3")));

TEST(ImageAntialiasingWays, WithJitterClose) {
  for (const char* method : {"+AM1", "+AM2"}) {
    for (const char* threshold : {"+A0.0", "+A0.1", "+A"}) {
      EXPECT_TRUE(same_as_stock(scene(kLinear, {method, threshold}), Grade::close))
          << method << threshold;
    }
  }
}

TEST(ImageAntialiasingWays, GammaOfTheComparison) {
  for (const char* gamma : {"+AG1", "+AG4", "Antialias_Gamma=0"}) {
    EXPECT_TRUE(same_as_stock(scene(kLinear, {"+A0.2", "-J", gamma}))) << gamma;
  }
}

TEST(ImageAntialiasingWays, WorkingGamma) {
  const std::string power = "#version 3.7; global_settings { assumed_gamma 2.2 }\n";
  const std::string srgb = "#version 3.7; global_settings { assumed_gamma srgb }\n";
  const std::string old = "#version 3.5;\n",
                    old_gamma = "#version 3.5; global_settings { assumed_gamma 1.8 }\n";
  for (const std::string& head : {power, srgb, old, old_gamma}) {
    for (const char* method : {"+AM1", "+AM2"}) {
      EXPECT_TRUE(same_as_stock(scene(head, {"+A0.2", "-J", method}))) << head << method;
    }
  }
}

TEST(ImageAntialiasingWays, AlphaIsAveragedAndCompared) {
  SceneText clear = scene(kLinear, {"+A0.1", "-J", "+UA"});
  clear.sdl =
      kLinear +
      "camera { location -5*z look_at 0 } light_source { <3,9,-4> rgb 1 }\n"
      "sphere { 0, 1.2 pigment { rgb 0.01 } } torus { 1.8, 0.1 rotate 70*x pigment { rgb 0.02 } }";
  for (const char* method : {"+AM1", "+AM2"}) {
    clear.arguments.push_back(method);
    EXPECT_TRUE(same_as_stock(clear)) << method;
  }
}

TEST(ImageAntialiasingWays, PlacesWithoutRay) {
  SceneText fish = scene(kLinear, {"+A0.1", "-J"});
  fish.sdl += "camera { fisheye location <0.4,2.2,-6> look_at <0,0.7,0> angle 160 }\n";
  for (const char* method : {"+AM1", "+AM2"}) {
    fish.arguments.push_back(method);
    EXPECT_TRUE(same_as_stock(fish)) << method;
  }
}

/// Twelve parts of a picture of several tiles, as columns and rows from 1, both ends included. (An end
/// of 1 is the whole width, as in stock.)
struct Part {
  int left, right, top, bottom;
};
constexpr Part kParts[] = {{1, 300, 1, 200},     {2, 2, 2, 2},        {300, 300, 200, 200},
                           {128, 129, 128, 129}, {129, 256, 1, 128},  {120, 140, 100, 160},
                           {1, 128, 129, 200},   {257, 300, 5, 9},    {30, 31, 1, 200},
                           {1, 300, 128, 128},   {200, 299, 60, 199}, {2, 127, 2, 127}};

void expect_parts(const std::vector<std::string>& way) {
  SceneText text = scene(kLinear, way);
  text.width = 300;
  text.height = 200;
  text.bits = 16;
  const StoredImage whole = lentray_render(text);
  ASSERT_EQ(whole.width, 300u);
  for (const Part& part : kParts) {
    const StoredImage cut = lentray_render(
        text, {"+SC" + std::to_string(part.left), "+EC" + std::to_string(part.right),
               "+SR" + std::to_string(part.top), "+ER" + std::to_string(part.bottom)});
    StoredImage expected = whole;
    const std::size_t channels = whole.samples.size() / (std::size_t{300} * 200);
    for (std::size_t i = 0; i < expected.samples.size(); ++i) {
      const int column = static_cast<int>(i / channels % 300) + 1,
                row = static_cast<int>(i / channels / 300) + 1;
      const bool inside =
          column >= part.left && column <= part.right && row >= part.top && row <= part.bottom;
      if (!inside) expected.samples[i] = 0.0f;
    }
    EXPECT_TRUE(same_bits(cut, expected)) << "columns " << part.left << " to " << part.right
                                          << ", rows " << part.top << " to " << part.bottom;
  }
}

TEST(ImageParts, WithoutAntialiasing) { expect_parts({}); }
TEST(ImageParts, MethodOne) { expect_parts({"+A0.1"}); }
TEST(ImageParts, MethodTwo) { expect_parts({"+A0.1", "+AM2"}); }
TEST(ImageParts, MethodOneOfASheet) { expect_parts({"+A0.1", "Lenticular=On", "Lens_Pixels=2"}); }
TEST(ImageParts, MethodTwoOfASheetOfFractionalLenses) {
  expect_parts({"+A0.1", "+AM2", "Lenticular=On", "Lens_Pixels=3.3"});
}
TEST(ImageParts, MethodOneOfASheetOfFractionalLenses) {
  expect_parts({"+A0.1", "Lenticular=On", "Lens_Pixels=1.6"});
}

TEST(ImageParts, AsStockCutsThem) {
  for (const std::vector<std::string>& part :
       std::vector<std::vector<std::string>>{{"+SC20", "+EC60"},
                                             {"+SR0.25", "+ER0.5"},
                                             {"+SC0.3", "+EC0.9", "+SR0.1", "+ER50"},
                                             {"+SC1", "+EC1.0"}}) {
    EXPECT_TRUE(same_as_stock(scene(kLinear, part))) << part.front();
  }
}

TEST(ImageParts, WhatLeavesNothingIsRefused) {
  const tool::TemporaryFolder folder;
  tool::write_text(folder / "a.pov", kLinear + kEdges);
  for (const auto& [option, message] : std::vector<std::pair<std::string, std::string>>{
           {"+SC200", "Start_Column lies beyond the picture's 80"},
           {"+ER70", "End_Row lies beyond the picture's 60"},
           {"+SR40", "Start_Row lies behind End_Row"}}) {
    const tool::RunResult run =
        run_lentray({"+Ia.pov", "+W80", "+H60", "+ER30", option, "+Oa.png", "-V"}, folder.path());
    EXPECT_NE(run.status, 0);
    EXPECT_NE(run.output.find(message), std::string::npos) << run.output;
    EXPECT_FALSE(std::filesystem::exists(folder / "a.png"));
  }
}

}  // namespace
}  // namespace lentray::test
