// Radiosity beside stock, which has one thread: its samples are the same, so pictures are, too. And
// truths that need no stock.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/support/render.h"

namespace lentray::test {
namespace {

/// An open box in the light of a sky, a ball that glows, and a lamp.
std::string room(const std::string& settings, const std::string& more = "") {
  return R"(#version 3.7;
global_settings { assumed_gamma 1 radiosity { )" +
         settings + R"( } }
camera { location <0, 1.2, -4.5> look_at <0, 0.9, 0> angle 50 }
light_source { <1.5, 3, -2> rgb 0.6 }
background { rgb <0.3, 0.4, 0.6> }
#default { finish { ambient 0.3 diffuse 0.7 } }
plane { y, 0 pigment { rgb <0.8, 0.8, 0.7> } }
plane { -z, -2 pigment { rgb <0.7, 0.3, 0.2> } }
box { <-2.2, 0, -1>, <-1.9, 1.8, 2> pigment { rgb <0.2, 0.7, 0.3> } }
sphere { <0.2, 0.5, 0.3>, 0.5 pigment { rgb 0.9 } }
sphere { <1.5, 0.6, 1>, 0.4 pigment { rgb <1, 0.8, 0.4> } finish { emission 2 diffuse 0 } }
)" + more;
}

SceneText scene_of(const std::string& sdl) {
  SceneText scene;
  scene.sdl = sdl;
  scene.width = 72;
  scene.height = 54;
  return scene;
}

struct Case {
  const char* name;
  const char* settings;
  const char* more = "";
};
std::ostream& operator<<(std::ostream& out, const Case& c) { return out << c.name; }

class ImageRadiosity : public ::testing::TestWithParam<Case> {};

TEST_P(ImageRadiosity, IsStocks) {
  EXPECT_TRUE(same_as_stock(scene_of(room(GetParam().settings, GetParam().more)), Grade::exact));
}

constexpr const char* kUsual = "count 40 error_bound 0.6 recursion_limit 2 ";

INSTANTIATE_TEST_SUITE_P(
    Each, ImageRadiosity,
    ::testing::Values(
        Case{"Defaults", ""}, Case{"OneBounce", "count 60 error_bound 0.5 recursion_limit 1"},
        Case{"ThreeBounces", "count 30 error_bound 0.8 recursion_limit 3"},
        Case{"Brightness", "count 40 error_bound 0.6 brightness 1.6"},
        Case{"GrayThreshold", "count 40 error_bound 0.6 gray_threshold 0.5"},
        Case{"MaxSample", "count 40 error_bound 0.6 max_sample 0.5"},
        Case{"Reuse", "count 40 error_bound 0.6 minimum_reuse 0.03 maximum_reuse 0.08"},
        Case{"LowErrorFactor", "count 40 error_bound 0.6 low_error_factor 0.9"},
        Case{"NearestCount", "count 40 error_bound 0.6 nearest_count 10"},
        Case{"AdaptivePretrace",
             "count 40 error_bound 0.9 nearest_count 8, 4 pretrace_start 0.2 pretrace_end 0.01"},
        Case{"Pretrace", "count 40 error_bound 0.6 pretrace_start 0.2 pretrace_end 0.02"},
        Case{"AlwaysSample", "count 20 error_bound 0.8 always_sample on"},
        Case{"AdcBailout", "count 40 error_bound 0.6 adc_bailout 0.3"},
        Case{"Pool", "count 40, 2000 error_bound 0.6"},
        Case{"Importance", kUsual,
             "sphere { <-0.9, 0.3, -0.8>, 0.3 pigment { rgb x } radiosity { importance 0.3 } }"},
        Case{"NoRadiosity", kUsual,
             "box { <-0.9, 0, -1.2>, <-0.4, 0.6, -0.8> pigment { rgb x } no_radiosity }"},
        Case{"Mirrors", kUsual,
             "sphere { <-0.9, 0.4, -0.8>, 0.4 pigment { rgb 0.2 } finish { reflection 0.7 } }"},
        Case{"Glass", kUsual,
             "sphere { <-0.9, 0.4, -0.8>, 0.4 pigment { rgbf 0.9 } interior { ior 1.4 } }"},
        Case{"Layers", kUsual,
             "sphere { <-0.9, 0.4, -0.8>, 0.4 texture { pigment { rgb x } } texture { pigment { "
             "checker rgb z, rgbt <1, 1, 0, 0.6> scale 0.2 } } }"},
        Case{"DiffuseBack", kUsual,
             "disc { <-0.9, 0.6, -0.8>, <1, 0.3, -0.4>, 0.5 pigment { rgb <1, 0.9, 0.4> } finish { "
             "diffuse 0.4, 0.5 } }"},
        Case{"Highlights", kUsual,
             "sphere { <-0.9, 0.4, -0.8>, 0.4 pigment { rgb x } finish { specular 0.8 phong 0.5 } "
             "}"},
        Case{"AreaLight", kUsual,
             "light_source { <-2, 4, -3> rgb 0.5 area_light x, z, 3, 3 adaptive 1 }"},
        Case{
            "Normal", "count 40 error_bound 0.8 normal on",
            "sphere { <-0.9, 0.4, -0.8>, 0.4 pigment { rgb 0.9 } normal { bumps 0.6 scale 0.2 } }"},
        Case{"Albedo", kUsual,
             "sphere { <-0.9, 0.4, -0.8>, 0.4 pigment { rgb 0.9 } finish { diffuse albedo 0.5 "
             "brilliance 3 } }"}),
    [](const auto& one) { return std::string(one.param.name); });

TEST(ImageRadiosityRules, AmbientEndsWithVersion37) {
  const std::string glowing =
      "global_settings { assumed_gamma 1 radiosity { count 20 recursion_limit 1 } }\n"
      "camera { location <0, 1, -8> look_at <0, 2, 0> }\n"
      "sphere { 0, 100 pigment { rgb <0.5, 0.6, 1> } finish { diffuse 0 ambient 1 } hollow "
      "no_shadow }\nplane { y, 0 pigment { rgb 0.7 } }\n";
  const StoredImage black = lentray_render(scene_of("#version 3.7;\n" + glowing));
  for (std::size_t i = 0; i < black.samples.size(); ++i) ASSERT_EQ(black.samples[i], 0.0f);
  EXPECT_TRUE(same_as_stock(scene_of("#version 3.6;\n" + glowing), Grade::exact));
}

TEST(ImageRadiosityRules, DarkScenesAreWarnedOf) {
  const tool::TemporaryFolder folder;
  tool::write_text(folder / "dark.pov",
                   "#version 3.7; global_settings { assumed_gamma 1 radiosity { } }\n"
                   "sphere { 3*z, 1 pigment { rgb 1 } finish { ambient 1 } }\n");
  const tool::RunResult run = run_lentray({"dark.pov", "+W16", "+H12", "-F"}, folder.path());
  EXPECT_EQ(run.status, 0) << run.output;
  EXPECT_NE(run.output.find("no light reaches any surface"), std::string::npos) << run.output;
  EXPECT_NE(run.output.find("`emission`"), std::string::npos) << run.output;
}

TEST(ImageRadiosityRules, StatisticsTellSamples) {
  const nlohmann::json all = lentray_statistics(scene_of(room(kUsual)));
  const nlohmann::json& levels = all.at("radiosity").at("levels");
  ASSERT_EQ(levels.size(), 3u);  // two of the pretrace, and the pixels
  EXPECT_EQ(levels.back().at("places"), 72 * 54);
  const nlohmann::json& first = levels.front().at("depths");
  ASSERT_EQ(first.size(), 2u);
  EXPECT_GT(first[0].at("samples"), 0);
  EXPECT_EQ(first[0].at("rays"), first[0].at("samples").get<int>() * 40);
  EXPECT_EQ(first[1].at("rays"), first[1].at("samples").get<int>() * 20);
}

TEST(ImageRadiosityRules, QualityBelow9IsWithout) {
  SceneText scene = scene_of(room(kUsual));
  scene.arguments = {"+Q8"};
  EXPECT_TRUE(same_as_stock(scene, Grade::exact));
}

/// A ball from within: e (1 + p + .. + p^bounces).
TEST(ImageRadiosityTruth, WhiteFurnace) {
  for (const int bounces : {1, 2, 3}) {
    SceneText scene = scene_of(
        "#version 3.7; global_settings { assumed_gamma 1 radiosity { recursion_limit " +
        std::to_string(bounces) +
        " } }\ncamera { location 0 direction z }\n"
        "sphere { 0, 10 pigment { rgb 1 } finish { ambient 0 emission 0.25 diffuse 0.5 } }\n");
    scene.arguments = {"File_Gamma=1.0"};
    scene.bits = 16;
    const StoredImage picture = lentray_render(scene);
    double truth = 0.0;
    for (int i = bounces; i >= 0; --i) truth = truth * 0.5 + 0.25;
    for (std::size_t i = 0; i < picture.samples.size(); ++i) {
      ASSERT_NEAR(picture.samples[i] / 65535.0, truth, 1e-4) << bounces << " bounces";
    }
  }
}

TEST(ImageRadiosityTruth, ThreadsOrdersAndBandsGiveTheSameBits) {
  const SceneText scene = scene_of(room(kUsual));
  const StoredImage one = lentray_render(scene, {"+WT1"});
  EXPECT_TRUE(same_bits(lentray_render(scene, {"+WT2"}), one));
  EXPECT_TRUE(same_bits(lentray_render(scene, {"+WT5", "Pixel_Order=hilbert"}), one));
  EXPECT_TRUE(same_bits(lentray_render(scene, {"+WT3", "Band_Height=8"}), one));
}

/// The sheet, its views together and one of them alone: the pass is over the sheet.
TEST(ImageRadiosityTruth, ViewsOfASheetShareOnePass) {
  const tool::TemporaryFolder folder;
  tool::write_text(folder / "a.pov", room(kUsual));
  const auto render = [&](std::vector<std::string> words) {
    words.insert(words.begin(), {"+Ia.pov", "-V", "-A", "Lenticular=On", "Lens_Pixels=3", "+W60",
                                 "+H40", "View_Size=40x30"});
    const auto result = run_lentray(words, folder.path());
    EXPECT_EQ(result.status, 0) << result.output;
  };
  const auto passes = [&](const char* file) {
    return nlohmann::json::parse(tool::read_text(folder / file))
        .value("passes", nlohmann::json::array())
        .size();
  };
  render({"Views=3", "+Oall.png", "Statistics_File=all.json"});
  EXPECT_EQ(passes("all0.json"), 1u);
  EXPECT_EQ(passes("all1.json"), 0u);
  EXPECT_EQ(passes("all2.json"), 0u);
  render({"Views=3", "+SF1", "+EF1", "+Oone.png", "Statistics_File=one.json"});
  EXPECT_EQ(passes("one1.json"), 1u);
  EXPECT_TRUE(
      same_bits(core::read_image(folder / "one1.png"), core::read_image(folder / "all1.png")));
}

TEST(ImageRadiosityTruth, SceneWithoutSurfacesIsItsSky) {
  EXPECT_TRUE(same_as_stock(
      scene_of("#version 3.7; global_settings { assumed_gamma 1 radiosity { } } background { rgb "
               "<0.3, 0.4, 0.6> }"),
      Grade::exact));
}

}  // namespace
}  // namespace lentray::test
