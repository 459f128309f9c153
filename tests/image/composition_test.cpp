// Sheets that are composed for a print, by the program: the middle view is what stock makes of the scene's own camera,
// other views are stock's from beside it, and what was true before data of a print were given stays.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/support/render.h"

namespace lentray::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// A floor to the horizon, something near, something far, and sky.
constexpr const char* kComposedScene = R"(#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0.5,1.5,-6> look_at <0,0.8,0> right x*4/3 }
light_source { <5,8,-6> rgb 1 }
background { rgb <0.2,0.3,0.5> }
plane { y, 0 pigment { checker rgb 0.9 rgb <0.4,0.5,0.2> } }
#declare Cup = cylinder { 0, y, 0.5 };
object { Cup translate <-0.6,0,-1> pigment { rgb <1,0.6,0.1> } }
sphere { <1.5,1,6>, 1 pigment { rgb <0.2,0.5,1> } finish { phong 0.4 } }
)";

const std::vector<std::string> kPrint{"Lenticular=On", "Lens_Sheet=40lpi", "Sheet_Width=40mm",
                                      "Sheet_Height=30mm", "Print_DPI=300"};

class ImageComposition : public ::testing::Test {
 protected:
  void SetUp() override { tool::write_text(m_folder / "a.pov", kComposedScene); }
  static std::vector<std::string> with(std::vector<std::string> words,
                                       const std::vector<std::string>& more) {
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
  tool::RunResult lentray(std::vector<std::string> words) const {
    words.insert(words.begin(), {"+Ia.pov", "-V"});
    return run_lentray(words, m_folder.path());
  }
  json lens_of(const std::vector<std::string>& words) const {
    const auto result = lentray(with(words, {"Statistics_File=s.json", "+Ostat.png"}));
    EXPECT_EQ(result.status, 0) << result.output;
    return json::parse(tool::read_text(m_folder / "s.json"))["lens"];
  }
  StoredImage read(const std::string& name) const { return core::read_image(m_folder / name); }
  static StoredImage by_stock(const std::string& camera, std::uint32_t width,
                              std::uint32_t height) {
    return stock_render({kComposedScene + camera, width, height});
  }

  const tool::TemporaryFolder m_folder;
};

StoredImage tile_of(const StoredImage& quilt, const json& tile, const StoredImage& like) {
  StoredImage out = like;
  std::vector<float> samples;
  const std::uint32_t left = tile["left"], top = tile["top"];
  for (std::uint32_t y = 0; y < like.height; ++y)
    for (std::uint32_t x = 0; x < like.width; ++x)
      for (int c = 0; c < like.channels; ++c) samples.push_back(quilt.at(left + x, top + y, c));
  out.samples = core::Samples(samples);
  return out;
}

/// Each tile of a quilt beside what stock makes of the scene from the camera of View_Cameras.
void expect_tiles_are_stocks(const StoredImage& quilt, const fs::path& cameras,
                             const std::string& scene, const std::vector<std::string>& options,
                             Grade grade) {
  for (const json& one : json::parse(tool::read_text(cameras))["cameras"]) {
    const json& p = one["povray"];
    const auto vector = [&p](const char* name) {
      const json& v = p[name];
      return std::string(name) + " <" + v[0].dump() + "," + v[1].dump() + "," + v[2].dump() + "> ";
    };
    const std::string camera = "\ncamera { " + vector("location") + vector("direction") +
                               vector("right") + vector("up") + "}\n";
    const StoredImage stock = stock_render({scene + camera, 48, 36, options});
    EXPECT_TRUE(reaches(tile_of(quilt, one["tile"], stock), stock, grade)) << one;
  }
}

bool composed_says(const tool::RunResult& result, const std::string& part) {
  return result.output.find(part) != std::string::npos;
}

TEST_F(ImageComposition, TheMiddleViewIsTheScenesOwnPicture) {
  for (const std::vector<std::string>& more :
       {std::vector<std::string>{}, {"Depth=scene"}, {"Sheet_At=Cup"}, {"View_Distance=inf"}}) {
    const auto done =
        lentray(with(with(kPrint, more), {"Views=5", "View=2", "View_Size=120x90", "+Ov.png"}));
    ASSERT_EQ(done.status, 0) << done.output;
    EXPECT_TRUE(reaches(read("v.png"), by_stock("", 120, 90), Grade::exact));
  }
}

TEST_F(ImageComposition, OtherViewsAreStocksFromBesideTheCamera) {
  const json lens = lens_of(with(kPrint, {"+SR1", "+ER2"}));
  const double distance = lens["scene_distance"], factor = lens["depth_factor"];
  EXPECT_GT(factor, 0.0);
  EXPECT_LT(factor, 1.0);
  const auto done =
      lentray(with(kPrint, {"Views=5", "View_Size=120x90", "+Ov.png", "View_Cameras=c.json"}));
  ASSERT_EQ(done.status, 0) << done.output;
  for (const int j : {0, 1, 4}) {
    // e_j in the print, and the eye that far beside the camera: b_j = -m D n e_j / f.
    const double e = ((j + 0.5) / 5.0 - 0.5) * lens["print_pitch_mm"].get<double>();
    const double beside =
        -factor * distance * lens["ior"].get<double>() * e / lens["focal_length_mm"].get<double>();
    // A perspective through the same window: direction and location move to opposite sides.
    char camera[512];
    std::snprintf(camera, sizeof camera,
                  "#declare B = %.17g; #declare D = %.17g;\n"
                  "#declare Ahead = vnormalize(<0,0.8,0> - <0.5,1.5,-6>);\n"
                  "#declare Right = vnormalize(vcross(y, Ahead));\n"
                  "camera { location <0.5,1.5,-6> + B*Right direction D*Ahead - B*Right\n"
                  "  right Right*4/3*D up vcross(Ahead, Right)*D }\n",
                  beside, distance);
    EXPECT_TRUE(
        reaches(read("v" + std::to_string(j) + ".png"), by_stock(camera, 120, 90), Grade::exact))
        << j;
  }
}

TEST_F(ImageComposition, SheetsOfAllModelsAreStocks) {
  for (const std::vector<std::string>& more :
       {std::vector<std::string>{"Lens_Pixels=5"},
        {"Print_DPI=210"},
        {"Lens_Pixels=5", "Lens_Model=pinhole"},
        {"Lens_Pixels=5", "View_Distance=inf"},
        {"Lens_Pixels=5", "Depth=scene", "Sheet_Distance=5"}}) {
    const auto done = run_diff(with({"a.pov", "Lenticular=On", "Lens_Sheet=40lpi",
                                     "Sheet_Width=25mm", "Sheet_Height=18mm", "--no-pictures"},
                                    more),
                               m_folder.path());
    EXPECT_EQ(done.status, 0) << done.output;
    EXPECT_TRUE(composed_says(done, "grade exact")) << done.output;
  }
}

TEST_F(ImageComposition, QuiltsAreComposedWhereThatIsAskedFor) {
  const auto plain = lentray({"Quilt=5x2", "Quilt_Tile=48x36", "+Oq.png", "--explain"});
  EXPECT_FALSE(composed_says(plain, "In the sheet's plane")) << plain.output;
  const auto done =
      lentray({"Quilt=5x2", "Quilt_Tile=48x36", "Depth=print", "+Oq.png", "View_Cameras=c.json"});
  ASSERT_EQ(done.status, 0) << done.output;
  EXPECT_TRUE(composed_says(done, "In the sheet's plane")) << done.output;
  EXPECT_TRUE(composed_says(done, "pixels a view at most")) << done.output;
  expect_tiles_are_stocks(read("q.png"), m_folder / "c.json", kComposedScene, {}, Grade::match);
}

TEST_F(ImageComposition, WithoutDataOfAPrintAllStaysAsItIs) {
  const auto same = [&](const std::vector<std::string>& a, const std::vector<std::string>& b) {
    for (const auto& [words, name] : {std::pair{a, "a.png"}, std::pair{b, "b.png"}}) {
      const auto done = lentray(with(words, {"+W150", "+H60", "+O" + std::string(name)}));
      EXPECT_EQ(done.status, 0) << done.output;
    }
    return same_bits(read("a.png"), read("b.png"));
  };
  EXPECT_TRUE(same({"Lenticular=On"}, {"Lenticular=On", "Depth=viewer"}));
  EXPECT_TRUE(same({"Lenticular=On", "View_Distance=300"},
                   {"Lenticular=On", "View_Distance=300", "Depth=viewer"}));
  EXPECT_FALSE(same({"Lenticular=On", "View_Distance=300"},
                    {"Lenticular=On", "View_Distance=300", "Depth=print"}));
}

TEST_F(ImageComposition, TheReportBeginsWithWhatMatters) {
  const auto done = lentray(with(kPrint, {"--explain"}));
  ASSERT_EQ(done.status, 0) << done.output;
  const std::size_t plane = done.output.find("In the sheet's plane, "),
                    depth = done.output.find("Depth: "), jumps = done.output.find("Jumps: none"),
                    sizes = done.output.find("Lens sheet ");
  EXPECT_LT(plane, depth);
  EXPECT_LT(depth, jumps);
  EXPECT_LT(jumps, sizes);
  EXPECT_FALSE(composed_says(done, "warning: jumps")) << done.output;
  const auto deep = lentray(with(kPrint, {"--explain", "Depth=scene"}));
  EXPECT_TRUE(composed_says(deep, "warning: jumps: ")) << deep.output;
  const auto viewers = lentray(with(kPrint, {"--explain", "Depth=viewer", "View_Distance=40cm"}));
  EXPECT_TRUE(composed_says(viewers, "warning: jumps: ")) << viewers.output;
  // An object that is put into the plane does not move.
  const auto cup = lentray(with(kPrint, {"--depth", "Sheet_At=Cup"}));
  EXPECT_TRUE(composed_says(cup, "(as Sheet_At=Cup asks): plane at a.pov:6:1, Cup at a.pov:8:1"))
      << cup.output;
  EXPECT_TRUE(composed_says(cup, "Cup at a.pov:8:1: 4.")) << cup.output;
}

TEST_F(ImageComposition, WhatIsWrongIsRefused) {
  for (const auto& [words, part] : std::vector<std::pair<std::vector<std::string>, std::string>>{
           {{"Sheet_At=Cup", "Sheet_Distance=4"},
            "Sheet_Distance and Sheet_At both say where the sheet stands: give one of them"},
           {{"Sheet_At=Mug"}, "Sheet_At=Mug: no visible object is called so; there are plane at "},
           {{"Depth=deep"}, "print, scene"}}) {
    const auto done = lentray(with(kPrint, words));
    EXPECT_EQ(done.status, 1);
    EXPECT_TRUE(composed_says(done, part)) << done.output;
    EXPECT_FALSE(fs::exists(m_folder / "a.png"));
  }
}

/// D and m come from the first, the middle and the last frame; a frame beyond them is named.
TEST_F(ImageComposition, FramesShareOneSheet) {
  tool::write_text(m_folder / "b.pov", R"(#version 3.7;
camera { location -10*z look_at 0 right x*4/3 }
light_source { <5,8,-6> rgb 1 }
plane { z, 5 pigment { rgb 1 } }
// Near in frame 2 of 9 alone.
sphere { (frame_number = 2 ? -7 : clock)*z, 0.5 pigment { rgb <1,0,0> } }
)");
  const std::vector<std::string> sheet{"+Ib.pov",          "+KFF9",
                                       "+Ob.png",          "-V",
                                       "Lenticular=On",    "Lens_Sheet=40lpi",
                                       "Sheet_Width=40mm", "Sheet_Height=30mm",
                                       "Lens_Pixels=5"};
  const auto done = run_lentray(with(sheet, {"Statistics_File=b.json"}), m_folder.path());
  ASSERT_EQ(done.status, 0) << done.output;
  const auto lens = [&](int frame) {
    return json::parse(tool::read_text(m_folder / ("b" + std::to_string(frame) + ".json")))["lens"];
  };
  for (int frame = 2; frame <= 9; ++frame) {
    EXPECT_EQ(lens(frame)["scene_distance"], lens(1)["scene_distance"]);
    EXPECT_EQ(lens(frame)["depth_factor"], lens(1)["depth_factor"]);
  }
  EXPECT_TRUE(composed_says(done, "(frame 2)")) << done.output;
  EXPECT_FALSE(composed_says(done, "(frame 3)")) << done.output;
  EXPECT_FALSE(fs::exists(m_folder / "b.png.lentray-depths"));
  // One frame of them alone has the same sheet, and the same picture.
  const StoredImage before = read("b4.png");
  const auto again = run_lentray(with(sheet, {"+SF4", "+EF4"}), m_folder.path());
  ASSERT_EQ(again.status, 0) << again.output;
  EXPECT_TRUE(same_bits(before, read("b4.png")));
}

class SlowCompositionExamples : public ::testing::TestWithParam<const char*> {};

/// Composed sheets of examples, view by view beside stock's oblique cameras.
TEST_P(SlowCompositionExamples, ViewsAreStocks) {
  const fs::path scene = fs::path("/usr/share/doc/povray/examples") / GetParam();
  if (!fs::exists(scene)) GTEST_SKIP() << "povray-examples is not installed";
  const tool::TemporaryFolder folder;
  const auto done = run_diff(
      {scene.string(), "Lenticular=On", "Lens_Sheet=40lpi", "Sheet_Width=60mm", "Sheet_Height=45mm",
       "Lens_Pixels=5", "--no-pictures", "+L" + scene.parent_path().string()},
      folder.path());
  EXPECT_EQ(done.status, 0) << done.output;
}

std::string example_name(const ::testing::TestParamInfo<const char*>& example) {
  std::string name = fs::path(example.param).stem().string();
  std::replace_if(
      name.begin(), name.end(), [](char c) { return !std::isalnum(c); }, '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(
    Composition, SlowCompositionExamples,
    ::testing::Values("advanced/sombrero.pov", "advanced/teapot/teapot3.pov",
                      "advanced/whiltile.pov", "advanced/woodbox.pov", "camera/perspective.pov",
                      "camera/orthographic.pov", "lights/parallel_lights.pov",
                      "lights/spotlite.pov", "objects/chesmsh.pov", "objects/csg/cliptst2.pov",
                      "objects/torus1.pov", "textures/finishes/arches.pov",
                      "textures/finishes/cluster.pov", "templates/Basic_Scenes/Checkered_plane.pov",
                      "objects/superel2.pov", "objects/blob.pov", "textures/patterns/agate.pov",
                      "interior/skysph1.pov", "interior/magglass.pov", "objects/superel1.pov"),
    example_name);

class SlowCompositionQuilts : public ::testing::TestWithParam<const char*> {};

TEST_P(SlowCompositionQuilts, TilesAreStocks) {
  const fs::path scene = fs::path("/usr/share/doc/povray/examples") / GetParam();
  if (!fs::exists(scene)) GTEST_SKIP() << "povray-examples is not installed";
  const tool::TemporaryFolder folder;
  const std::string library = "+L" + scene.parent_path().string();
  const auto done =
      run_lentray({"+I" + scene.string(), library, "-V", "-A", "Quilt=5x2", "Quilt_Tile=48x36",
                   "Depth=print", "+Oq.png", "View_Cameras=c.json"},
                  folder.path());
  ASSERT_EQ(done.status, 0) << done.output;
  expect_tiles_are_stocks(core::read_image(folder / "q.png"), folder / "c.json",
                          tool::read_text(scene), {library}, Grade::match);
}

INSTANTIATE_TEST_SUITE_P(Composition, SlowCompositionQuilts,
                         ::testing::Values("advanced/woodbox.pov", "camera/perspective.pov",
                                           "objects/chesmsh.pov", "lights/spotlite.pov",
                                           "textures/finishes/arches.pov"),
                         example_name);

}  // namespace
}  // namespace lentray::test
