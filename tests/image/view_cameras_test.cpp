// View_Cameras=: the cameras that lentray writes for other programs, taken to stock, make a quilt's tiles and the
// pictures of views.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/support/render.h"

namespace lentray::test {
namespace {

using nlohmann::json;

/// Nothing of it is before where rays start, from which stock sees it too.
constexpr const char* kCameraScene = R"(#version 3.7;
global_settings { assumed_gamma 1 }
light_source { <5,8,-6> rgb 1 }
background { rgb <0.2,0.3,0.5> }
plane { z, 2.6 pigment { checker rgb 0.9 rgb <0.4,0.5,0.2> } }
sphere { <0.6,0,1.5>, 0.9 pigment { rgb <1,0.6,0.1> } finish { phong 0.4 } }
sphere { <-0.9,-0.3,-0.8>, 0.5 pigment { rgb <0.2,0.5,1> } }
)";
constexpr const char* kAskew =
    "camera { location <1,1.5,-5> look_at <0,0.2,0> right x*4/3 sky <0.2,1,0> }\n";
constexpr const char* kRightHanded = "camera { location <0,0.5,-5> right -x*4/3 look_at 0 }\n";
constexpr const char* kFromFar =
    "camera { orthographic location <0,1,-5> look_at 0 right x*4 up y*3 }\n";

std::string sdl_vector(const json& v) {
  return "<" + v[0].dump() + "," + v[1].dump() + "," + v[2].dump() + ">";
}

StoredImage part_of(const StoredImage& image, std::uint32_t left, std::uint32_t top,
                    std::uint32_t width, std::uint32_t height) {
  StoredImage out = image;
  out.width = width;
  out.height = height;
  std::vector<float> samples;
  for (std::uint32_t y = top; y < top + height; ++y) {
    for (std::uint32_t x = left; x < left + width; ++x) {
      for (int c = 0; c < image.channels; ++c) samples.push_back(image.at(x, y, c));
    }
  }
  out.samples = core::Samples(samples);
  return out;
}

class ImageViewCameras : public ::testing::Test {
 protected:
  tool::RunResult lentray(std::vector<std::string> words) const {
    words.insert(words.begin(), {"+Ia.pov", "-V", "View_Cameras=c.json"});
    return run_lentray(words, m_folder.path());
  }
  void expect_done(const std::string& camera, const std::vector<std::string>& words) const {
    tool::write_text(m_folder / "a.pov", kCameraScene + camera);
    const auto result = lentray(words);
    ASSERT_EQ(result.status, 0) << result.output;
  }
  json told() const {
    std::ifstream file(m_folder / "c.json");
    return json::parse(file);
  }
  StoredImage read(const std::string& name) const { return core::read_image(m_folder / name); }
  /// Stock's picture by a camera of the file.
  static StoredImage by_stock(const json& one) {
    const json& p = one["povray"];
    SceneText scene;
    scene.sdl = kCameraScene;
    scene.sdl += "camera { " + one["projection"].get<std::string>() + " location " +
                 sdl_vector(p["location"]) + " direction " + sdl_vector(p["direction"]) +
                 " right " + sdl_vector(p["right"]) + " up " + sdl_vector(p["up"]) + " }\n";
    scene.width = one["size"][0];
    scene.height = one["size"][1];
    return stock_render(scene);
  }

  const tool::TemporaryFolder m_folder;
};

TEST_F(ImageViewCameras, TilesOfQuiltsAreStocksPictures) {
  const std::vector<std::pair<std::string, std::vector<std::string>>> cases{
      {kAskew, {}},
      {kAskew, {"Quilt_Aspect=0.75", "View_Cone=50", "Sheet_Distance=4"}},
      {kAskew, {"View_Distance=inf"}},
      {kRightHanded, {}},
      {kFromFar, {}}};
  for (const auto& [camera, more] : cases) {
    std::vector<std::string> words{"Quilt=3x2", "Quilt_Tile=64x48", "+Oq.png"};
    words.insert(words.end(), more.begin(), more.end());
    expect_done(camera, words);
    const StoredImage quilt = read("q.png");
    const json all = told();
    ASSERT_EQ(all["cameras"].size(), 6u);
    EXPECT_EQ(all["handedness"], camera == kRightHanded ? "right" : "left");
    for (const json& one : all["cameras"]) {
      EXPECT_LT(one["largest_miss"].get<double>(), 1e-12);
      const StoredImage tile = part_of(quilt, one["tile"]["left"], one["tile"]["top"], 64, 48);
      EXPECT_TRUE(reaches(tile, by_stock(one), Grade::match)) << camera << one;
    }
  }
}

/// The leftmost camera first, from the lower left.
TEST_F(ImageViewCameras, OrderAndNumbers) {
  expect_done("camera { location -5*z look_at 0 right x*2 }\n",
              {"Quilt=4x2", "Quilt_Tile=40x20", "View_Cone=40", "--explain"});
  EXPECT_FALSE(std::filesystem::exists(m_folder / "a.png"));
  const json all = told();
  EXPECT_EQ(all["quilt"]["view_cone_degrees"], 40.0);
  EXPECT_EQ(all["quilt"]["width"], 160);
  const double reach = 5.0 * std::tan(20.0 * M_PI / 180.0);
  for (int i = 0; i < 8; ++i) {
    const json& one = all["cameras"][static_cast<std::size_t>(i)];
    EXPECT_EQ(one["number"], i);
    EXPECT_EQ(one["view"], 7 - i);
    EXPECT_EQ(one["tile"]["column"], i % 4);
    EXPECT_EQ(one["tile"]["row"], i / 4);
    EXPECT_EQ(one["tile"]["top"], i < 4 ? 20 : 0);
    const double x = reach * (2.0 * i / 7.0 - 1.0);
    EXPECT_NEAR(one["location"][0], x, 1e-9);
    EXPECT_NEAR(one["location"][2], -5.0, 1e-9);
    EXPECT_NEAR(one["distance"], 5.0, 1e-9);
    // The window: the sheet, 10 wide and 5 high about the origin.
    EXPECT_NEAR(one["frustum"]["left"], (-5.0 - x) / 5.0, 1e-9);
    EXPECT_NEAR(one["frustum"]["right"], (5.0 - x) / 5.0, 1e-9);
    EXPECT_NEAR(one["frustum"]["top"], 0.5, 1e-9);
    EXPECT_NEAR(one["shift"][0], -x / 10.0, 1e-9);
    EXPECT_NEAR(one["field_of_view_degrees"][0], 90.0, 1e-9);
    EXPECT_EQ(one["look_direction"], json({0.0, 0.0, 1.0}));
  }
}

/// Of a lens sheet's views too, in any size, and of its strips.
TEST_F(ImageViewCameras, PicturesOfViewsAreStocksPictures) {
  for (const std::string distance : {"View_Distance=400", "View_Distance=inf"}) {
    const std::vector<std::string> sheet{"Lenticular=On", "Lens_Pixels=5", "+W200",
                                         "+H30",          distance,        "Lens_LPI=20"};
    std::vector<std::string> words = sheet;
    words.insert(words.end(), {"Views=3", "View_Size=64x48", "+Ov.png"});
    expect_done(kAskew, words);
    json all = told();
    ASSERT_EQ(all["cameras"].size(), 3u);
    for (const json& one : all["cameras"]) {
      EXPECT_LT(one["largest_miss"].get<double>(), 1e-12);
      const StoredImage view = read("v" + std::to_string(one["view"].get<int>()) + ".png");
      EXPECT_TRUE(reaches(view, by_stock(one), Grade::match)) << one;
    }
    words = sheet;
    words.insert(words.end(), {"View=1", "+Os.png"});
    expect_done(kAskew, words);
    all = told();
    ASSERT_EQ(all["cameras"].size(), 5u);
    const json& strip = all["cameras"][3];
    EXPECT_EQ(strip["view"], 1);
    EXPECT_TRUE(reaches(read("s.png"), by_stock(strip), Grade::match)) << strip;
  }
}

/// A farm's part of the views.
TEST_F(ImageViewCameras, SomeViewsTellOfAllOnce) {
  const std::vector<std::string> sheet{"Lenticular=On", "+W60",    "+H10", "Views=4",
                                       "View_Size=8x6", "+Ov.png", "+SF2"};
  for (const std::string last : {"+EF2", "+EF3"}) {
    std::vector<std::string> words = sheet;
    words.push_back(last);
    expect_done(kAskew, words);
    EXPECT_FALSE(std::filesystem::exists(m_folder / "v1.png"));
    EXPECT_EQ(told()["cameras"].size(), 4u);
    std::filesystem::remove(m_folder / "c.json");
  }
  std::vector<std::string> words = sheet;
  words.push_back("View_Cameras=-");
  const auto result = lentray(words);
  const std::size_t first = result.output.find("\"cameras\"");
  EXPECT_NE(first, std::string::npos) << result.output;
  EXPECT_EQ(result.output.find("\"cameras\"", first + 1), std::string::npos) << result.output;
}

TEST_F(ImageViewCameras, WithoutASheetThereAreNone) {
  tool::write_text(m_folder / "a.pov", std::string(kCameraScene) + kAskew);
  const auto result = lentray({"--explain"});
  EXPECT_EQ(result.status, 1);
  EXPECT_NE(
      result.output.find("View_Cameras= gives the cameras of views: add Lenticular=On, or Quilt="),
      std::string::npos)
      << result.output;
  EXPECT_FALSE(std::filesystem::exists(m_folder / "c.json"));
}

}  // namespace
}  // namespace lentray::test
