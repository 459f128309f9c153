// Subsurface light beside stock: random numbers differ, light does not.
#include <gtest/gtest.h>

#include <string>

#include "tests/support/render.h"
#include "tests/support/stock_noise.h"

namespace lentray::test {
namespace {

constexpr const char* kMoreSamples = "subsurface { samples 200, 40 }";  ///< where noise is great
constexpr const char* kSamples = "mm_per_unit 10 subsurface { samples 50, 20 }";

SceneText translucent(const std::string& objects, const std::string& settings = kSamples) {
  SceneText scene;
  scene.sdl = "#version 3.7; global_settings { assumed_gamma 1 " + settings + R"( }
camera { location <0, 1.2, -5> look_at <0, 0.2, 0> angle 42 right x*image_width/image_height }
light_source { <-5, 8, -6> rgb 1 }
plane { y, -1 pigment { checker rgb 0.7 rgb 0.3 } finish { ambient 0.05 } }
#default { finish { ambient 0 } }
)" + objects;
  scene.width = 64;
  scene.height = 48;
  return scene;
}

constexpr const char* kBall =
    "sphere { 0, 1 pigment { rgb <0.8, 0.6, 0.4> } finish { subsurface { translucency 1.5 } } "
    "interior { ior 1.4 } }\n";

struct Case {
  const char* name;
  const char* objects;
  const char* settings = kSamples;
};
std::ostream& operator<<(std::ostream& out, const Case& c) { return out << c.name; }

class ImageSubsurface : public ::testing::TestWithParam<Case> {};

TEST_P(ImageSubsurface, IsStocksWithinItsNoise) {
  EXPECT_TRUE(within_stocks_noise(translucent(GetParam().objects, GetParam().settings)));
}

INSTANTIATE_TEST_SUITE_P(
    Each, ImageSubsurface,
    ::testing::Values(
        Case{"Marble",
             "sphere { 0, 1 pigment { agate color_map { [0.5 rgb <0.83, 0.79, 0.75>] [1 rgb <0.5, "
             "0.35, 0.3>] } scale 0.3 } finish { specular 0.4 subsurface { translucency <2.19, "
             "2.62, 3> } } interior { ior 1.5 } }"},
        Case{"SlabWithLightBehind",
             "light_source { <1, 1, 6> rgb 0.8 } box { <-1.5, -1, 0>, <1.5, 1, 0.15> pigment { rgb "
             "<0.9, 0.7, 0.5> } finish { diffuse 0.8 subsurface { translucency <4, 2, 1> } } "
             "interior { ior 1 } } sphere { <0, 0.2, 1>, 0.4 pigment { rgb 0.2 } }",
             kMoreSamples},
        Case{"Csg",
             "difference { box { -1, 1 } sphere { <-0.5, 0.6, -1>, 0.9 } cylinder { -2*x, 2*x, 0.4 "
             "} pigment { rgb <0.6, 0.8, 0.9> } finish { diffuse 0.9 subsurface { translucency "
             "<0.5, 2, 6> } } interior { ior 2 } rotate 30*y }",
             kMoreSamples},
        Case{"BlendedAndLayered",
             "sphere { -0.9*x + z, 0.9 texture { bozo texture_map { [0.4 pigment { rgb <0.9, 0.5, "
             "0.3> } finish { subsurface { translucency 2 } }] [0.6 pigment { rgb <0.3, 0.5, 0.9> "
             "} finish { subsurface { translucency <1, 2, 3> } }] } scale 0.4 } interior { ior 1.4 "
             "} } sphere { <0.8, -0.2, -0.3>, 0.7 texture { pigment { rgb <0.9, 0.9, 0.8> } finish "
             "{ subsurface { translucency 30 } } } texture { pigment { gradient y color_map { [0.5 "
             "rgb <0.2, 0.8, 0.2>] [0.5 rgbt 1] } scale 0.3 } } interior { ior 1.2 } }"},
        Case{"ClearAndSeenThroughEachOther",
             "sphere { <0, 0, -0.5>, 0.8 pigment { rgb 0.9 } finish { diffuse 0.9 subsurface { "
             "translucency 60 } } interior { ior 1.1 } } sphere { <0.6, 0, 1.6>, 1 pigment { rgb "
             "<0.9, 0.4, 0.2> } finish { subsurface { translucency 40 } } interior { ior 1.1 } }"},
        Case{"Blob",
             "blob { threshold 0.5 cylinder { -y, y, 1, 1 } sphere { <0, 1, -0.3>, 0.5, -1 } "
             "pigment { rgb <0.8, 0.5, 0.01> } finish { diffuse 0.6 subsurface { translucency "
             "<2.5, 1.5, "
             "0.5> } } interior { ior 1.45 } }",
             "mm_per_unit 40 subsurface { samples 100, 20 }"},
        Case{"Radiosity", kBall,
             "subsurface { samples 50, 20 } radiosity { count 60 error_bound 0.6 }"}),
    [](const auto& one) { return std::string(one.param.name); });

INSTANTIATE_TEST_SUITE_P(
    Slow, ImageSubsurface,
    ::testing::Values(
        Case{"ScaleAndLights",
             "light_source { <4, 3, -3> rgb <0.7, 0.5, 0.4> spotlight point_at 0 radius 8 falloff "
             "14 area_light x, y, 3, 3 fade_distance 4 fade_power 2 } merge { sphere { -0.5*x, 0.8 "
             "} sphere { 0.6*x, 0.7 } pigment { rgb <0.9, 0.8, 0.6> } finish { diffuse 0.7 "
             "subsurface { translucency <6, 3, 2> } } interior { ior 1.3 } }",
             "mm_per_unit 60 subsurface { samples 50, 20 }"},
        Case{"AreaIllumination",
             "light_source { <4, 3, -3> rgb 0.7 area_light x*3, y*3, 3, 3 area_illumination on "
             "fade_distance 4 fade_power 2 } sphere { 0, 1 pigment { rgb 0.8 } finish { subsurface "
             "{ translucency 2 } } interior { ior 1.3 } } box { <0.5, 0.5, -2>, <1, 1, -1.5> }"},
        Case{"LightGroup",
             "light_group { light_source { <3, 2, -3> rgb <0, 0.3, 0.6> } sphere { 0, 1 pigment { "
             "rgb 0.9 } finish { subsurface { translucency 1 } } interior { ior 1.3 } } "
             "global_lights off }"},
        Case{"NestedGlass",
             "sphere { 0, 1 pigment { rgbf <0.9, 0.8, 0.7, 0.6> } finish { subsurface { "
             "translucency 4 } } interior { ior 1.5 } } sphere { <0.2, 0, 0.1>, 0.4 pigment { rgb "
             "<0.2, 0.3, 0.9> } finish { subsurface { translucency 1 } } interior { ior 1.2 } } "
             "sphere { <-1.4, -0.5, -0.8>, 0.5 pigment { rgbt 0.9 } interior { ior 1.5 } finish { "
             "diffuse 0 specular 0.6 } } sphere { <-1.4, -0.5, -0.8>, 0.3 pigment { rgb <0.9, 0.9, "
             "0.4> } finish { subsurface { translucency 2 } } interior { ior 1.3 } }",
             kMoreSamples},
        Case{"RadiosityIsScattered", kBall,
             "subsurface { samples 20, 10 radiosity on } radiosity { count 40 error_bound 0.6 }"},
        Case{"RadiositySeesScattered", kBall,
             "subsurface { samples 20, 10 } radiosity { count 20 error_bound 0.6 subsurface on }"}),
    [](const auto& one) { return std::string(one.param.name); });

TEST(ImageSubsurfaceRules, WithoutTheSceneWantingItDiffuseLightStays) {
  EXPECT_TRUE(same_as_stock(translucent(kBall, ""), Grade::exact));
  SceneText quick = translucent(kBall);
  quick.arguments = {"+Q8"};
  EXPECT_TRUE(same_as_stock(quick, Grade::exact));
}

TEST(ImageSubsurfaceRules, WithoutSamplesItIsDark) {
  EXPECT_TRUE(same_as_stock(translucent(kBall, "subsurface { samples 0, -3 }"), Grade::exact));
}

/// Stock stops at the first two.
TEST(ImageSubsurfaceRules, WhatStockCannotRenderIsAsNearAsCanBe) {
  const SceneText opaque = translucent(
      "sphere { 0, 1 pigment { rgb 0.8 } finish { subsurface { translucency 0 } } interior { ior "
      "1.2 } }");
  const SceneText nearly = translucent(
      "sphere { 0, 1 pigment { rgb 0.8 } finish { subsurface { translucency 0.002 } } interior { "
      "ior 1.2 } }");
  const StoredImage solid = lentray_render(opaque);
  EXPECT_LT(
      core::compare(solid, lentray_render(nearly), core::Columns::all(solid.width)).blocks.rms,
      0.5);
  const SceneText red = translucent(
      "sphere { 0, 1 pigment { rgb <0.8, 0, 0> } finish { subsurface { translucency 1 } } "
      "interior { ior 1.2 } }");
  const StoredImage picture = lentray_render(red);
  const auto middle = core::level(picture, picture.width / 2, picture.height / 2);
  EXPECT_GT(middle[0], 100.0);
  EXPECT_EQ(middle[1], 0.0);
  EXPECT_EQ(middle[2], 0.0);
}

TEST(ImageSubsurfaceRules, WhatCannotBeIsWarnedOf) {
  const tool::TemporaryFolder folder;
  tool::write_text(folder / "odd.pov",
                   translucent("sphere { 0, 1 pigment { rgb 0.8 } finish {\n subsurface { "
                               "translucency <1, 0, 1> } } }",
                               "mm_per_unit 0 subsurface { }")
                       .sdl);
  const tool::RunResult run = run_lentray({"odd.pov", "+W16", "+H12", "-F"}, folder.path());
  EXPECT_EQ(run.status, 0) << run.output;
  EXPECT_NE(run.output.find("odd.pov:1:31: warning: mm_per_unit is not greater than 0"),
            std::string::npos)
      << run.output;
  EXPECT_NE(run.output.find("odd.pov:6:42: warning: translucency is too little"), std::string::npos)
      << run.output;
}

}  // namespace
}  // namespace lentray::test
