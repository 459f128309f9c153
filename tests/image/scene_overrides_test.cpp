// Options that hold instead of what a scene says of its sampling: each has the picture of a scene
// that says it itself. Antialias_Grid has the means of a picture with more pixels.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "tests/support/render.h"

namespace lentray::test {
namespace {

struct Words {
  std::string global = "max_trace_level 5";
  std::string area = "9, 9 adaptive 1";
  std::string blur = "blur_samples 19 variance 0.01 confidence 0.9";
};

/// Two mirrors that face each other, glass, an area light with a small ball before it and a camera out of
/// focus.
SceneText scene_overrides_scene_of(const Words& words) {
  return {.sdl = "#version 3.7; global_settings { assumed_gamma 1 " + words.global + R"( }
camera { location <0, 1.5, -4> look_at <0, 0.6, 0> aperture 0.5 focal_point <0, 0.6, -1> )" +
                 words.blur + R"( }
light_source { <-3, 6, -4> 1 area_light x*2, z*2, )" +
                 words.area + R"( }
plane { y, 0 pigment { checker rgb 1 rgb <0.2, 0.4, 0.8> } }
box { <-2, 0, 1>, <2, 2, 1.1> pigment { rgb 0.2 } finish { reflection 0.8 } }
box { <-2, 0, -5>, <2, 2, -4.9> pigment { rgb 0.2 } finish { reflection 0.8 } }
sphere { <-2, 3, -2.5>, 0.12 pigment { rgb 1 } }
sphere { <0, 0.6, 0>, 0.6 pigment { rgbf <1, 0.9, 0.8, 0.9> } finish { reflection 0.1 }
  interior { ior 1.5 } }
)",
          .arguments = {"File_Gamma=1.0", "-A"},
          .bits = 16};
}

struct OverrideCase {
  const char* option;
  Words scene;  ///< that says it itself
};

class ImageSceneOverrides : public ::testing::TestWithParam<OverrideCase> {};

TEST_P(ImageSceneOverrides, HaveThePictureOfASceneThatSaysSo) {
  const auto& [option, scene] = GetParam();
  const StoredImage plain = lentray_render(scene_overrides_scene_of({}));
  const StoredImage by_option = lentray_render(scene_overrides_scene_of({}), {option});
  EXPECT_FALSE(same_bits(plain, by_option)) << "the option shows in this scene";
  EXPECT_TRUE(same_bits(by_option, lentray_render(scene_overrides_scene_of(scene))));
}

INSTANTIATE_TEST_SUITE_P(
    All, ImageSceneOverrides,
    ::testing::Values(OverrideCase{"Max_Trace_Level=2", {.global = "max_trace_level 2"}},
                      OverrideCase{"Adc_Bailout=0.3",
                                   {.global = "max_trace_level 5 adc_bailout 0.3"}},
                      OverrideCase{"Area_Light_Samples=5", {.area = "5, 5 adaptive 1"}},
                      OverrideCase{"Area_Light_Adaptive=0", {.area = "9, 9 adaptive 0"}},
                      OverrideCase{"Area_Light_Adaptive=off", {.area = "9, 9"}},
                      OverrideCase{"Blur_Samples=5",
                                   {.blur = "blur_samples 5, 5 variance 0.01 confidence 0.9"}}));

SceneText scene_overrides_radiosity(const std::string& settings) {
  return {.sdl = "#version 3.7; global_settings { assumed_gamma 1 radiosity { " + settings + R"( } }
camera { location <0, 1.5, -4> look_at <0, 0.6, 0> }
background { rgb <0.5, 0.6, 0.8> }
plane { y, 0 pigment { rgb <0.9, 0.5, 0.4> } }
box { <-1, 0, 0>, <1, 1, 1> pigment { rgb <0.4, 0.8, 0.5> } }
)",
          .width = 60,
          .height = 45,
          .bits = 16};
}

TEST(ImageSceneOverridesOfRadiosity, HaveThePictureOfASceneThatSaysSo) {
  const StoredImage plain = lentray_render(scene_overrides_radiosity("count 20"));
  for (const auto& [option, settings] :
       {std::pair{"Radiosity_Count=45", "count 45"},
        std::pair{"Radiosity_Error_Bound=0.4", "count 20 error_bound 0.4"},
        std::pair{"Radiosity_Nearest_Count=9", "count 20 nearest_count 9"},
        std::pair{"Radiosity_Recursion_Limit=1", "count 20 recursion_limit 1"}}) {
    const StoredImage by_option = lentray_render(scene_overrides_radiosity("count 20"), {option});
    EXPECT_FALSE(same_bits(plain, by_option)) << option << " shows in this scene";
    EXPECT_TRUE(same_bits(by_option, lentray_render(scene_overrides_radiosity(settings))))
        << option;
  }
}

SceneText scene_overrides_glass(const std::string& settings) {
  return {.sdl = "#version 3.7; global_settings { assumed_gamma 1 " + settings + R"( }
camera { location <0, 3, -4> look_at <0, 0.6, 0> }
light_source { <1, 5, -1> 1 }
plane { y, -0.01 pigment { rgb 0.9 } }
sphere { y, 0.6 pigment { rgbf 0.95 } interior { ior 1.5 } photons { target refraction on } }
)",
          .width = 60,
          .height = 45,
          .bits = 16};
}

TEST(ImageSceneOverridesOfPhotons, HaveThePictureOfASceneThatSaysSo) {
  const SceneText scene = scene_overrides_glass("photons { spacing 0.05 gather 10, 90 }");
  const StoredImage plain = lentray_render(scene);
  for (const auto& [option, settings] :
       {std::pair{"Photon_Count=900", "count 900 gather 10, 90"},
        std::pair{"Photon_Gather=40", "spacing 0.05 gather 10, 40"},
        std::pair{"Photon_Gather=7", "spacing 0.05 gather 7, 7"}}) {
    const StoredImage by_option = lentray_render(scene, {option});
    EXPECT_FALSE(same_bits(plain, by_option)) << option << " shows in this scene";
    EXPECT_TRUE(same_bits(by_option, lentray_render(scene_overrides_glass(
                                         std::string("photons { ") + settings + " }"))))
        << option;
  }
}

SceneText scene_overrides_marble(const std::string& samples) {
  return {.sdl = "#version 3.7; global_settings { assumed_gamma 1 subsurface { samples " + samples +
                 R"( } }
camera { location -4*z look_at 0 }
light_source { <-5, 8, -6> 1 }
sphere { 0, 1 pigment { rgb <0.8, 0.6, 0.4> } finish { subsurface { translucency 1.5 } } interior { ior 1.4 } }
)",
          .width = 24,
          .height = 18,
          .bits = 16};
}

TEST(ImageSceneOverridesOfSubsurfaceLight, HaveThePictureOfASceneThatSaysSo) {
  const StoredImage plain = lentray_render(scene_overrides_marble("20, 10"));
  const StoredImage by_option =
      lentray_render(scene_overrides_marble("20, 10"), {"Subsurface_Samples=12"});
  EXPECT_FALSE(same_bits(plain, by_option));
  EXPECT_TRUE(same_bits(by_option, lentray_render(scene_overrides_marble("12, 12"))));
}

TEST(ImageSceneOverridesAlone, TurnNothingOn) {
  const SceneText scene{.sdl =
                            "camera { location -4*z look_at 0 } light_source { -9*z 1 }\n"
                            "sphere { 0, 1 pigment { rgb 1 } }\n",
                        .bits = 16};
  EXPECT_TRUE(same_bits(
      lentray_render(scene),
      lentray_render(scene, {"Area_Light_Samples=5", "Area_Light_Adaptive=2", "Blur_Samples=9",
                             "Max_Trace_Level=9", "Radiosity_Count=99", "Photon_Count=99",
                             "Photon_Gather=9", "Subsurface_Samples=9"})));
}

TEST(ImageAntialiasGrid, IsTheMeanOfAPictureWithMorePixels) {
  constexpr std::uint32_t kGrid = 3;
  SceneText scene = scene_overrides_scene_of({.area = "1, 1", .blur = ""});
  const StoredImage grid = lentray_render(scene, {"Antialias_Grid=3", "+A", "+J"});
  scene.width *= kGrid;
  scene.height *= kGrid;
  const StoredImage fine = lentray_render(scene);
  double largest = 0.0;
  for (std::uint32_t row = 0; row < grid.height; ++row) {
    for (std::uint32_t column = 0; column < grid.width; ++column) {
      std::array<double, 3> mean{};
      for (std::uint32_t k = 0; k < kGrid * kGrid; ++k) {
        const auto one = core::level(fine, column * kGrid + k % kGrid, row * kGrid + k / kGrid);
        for (int i = 0; i < 3; ++i) mean[i] += std::min(one[i], 255.0) / (kGrid * kGrid);
      }
      const auto here = core::level(grid, column, row);
      for (int i = 0; i < 3; ++i) largest = std::max(largest, std::fabs(here[i] - mean[i]));
    }
  }
  EXPECT_LT(largest, 2.0 / 257.0);  // of 255: rounding to 16 bits, twice
}

/// On a lens sheet a pixel's area is its lens's width: a grid is the mean over its views' pixels.
TEST(ImageAntialiasGrid, OfASheetIsThatOfItsViews) {
  SceneText scene = scene_overrides_scene_of({.area = "1, 1", .blur = ""});
  scene.width = 60;
  scene.arguments.insert(scene.arguments.end(), {"Lenticular=On", "Lens_Pixels=3"});
  const StoredImage sheet = lentray_render(scene, {"Antialias_Grid=2"});
  const StoredImage view = lentray_render(scene, {"Antialias_Grid=2", "View=1"});
  ASSERT_EQ(view.width, 20u);
  double largest = 0.0;
  for (std::uint32_t row = 0; row < view.height; ++row) {
    for (std::uint32_t lens = 0; lens < view.width; ++lens) {
      const auto a = core::level(sheet, lens * 3 + 1, row), b = core::level(view, lens, row);
      for (int i = 0; i < 3; ++i) largest = std::max(largest, std::fabs(a[i] - b[i]));
    }
  }
  EXPECT_EQ(largest, 0.0);
  EXPECT_FALSE(same_bits(sheet, lentray_render(scene)));
}

}  // namespace
}  // namespace lentray::test
