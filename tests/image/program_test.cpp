// The program from outside: options and files, what is written where, and what it says.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/image/reader.h"
#include "tests/support/render.h"
#include "tools/common/process.h"
#include "tools/common/version.h"

namespace lentray::test {
namespace {

namespace fs = std::filesystem;

/// Reflection, glass, an area light and a quick_color: whatever a quality level can leave out.
constexpr const char* kProgramScene = R"(#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0,2,-6> look_at <0,0.75,0> }
light_source { <-5,8,-6>, 1 area_light x*2, y*2, 3, 3 }
light_source { <5,3,-6>, 0.4 }
plane { y, 0 pigment { checker rgb <1,.8,.6> rgb <.2,.3,.4> } finish { ambient .15 diffuse .7 } }
sphere { <0,1,0>, 1
  pigment { rgb <.9,.3,.2> quick_color rgb <0,0,1> } finish { phong .7 reflection .3 ambient .2 } }
sphere { <1.8,.7,-1>, .7
  pigment { rgbt <.9,.9,1,.8> } interior { ior 1.4 } finish { specular .5 reflection .1 } }
box { <-2.5,0,-1>, <-1.5,1.2,0> pigment { rgbf <.3,.9,.3,.6> } }
)";

class ImageProgram : public ::testing::Test {
 protected:
  void SetUp() override { tool::write_text(m_folder / "scene.pov", kProgramScene); }
  tool::RunResult lentray(const std::vector<std::string>& arguments) {
    return run_lentray(arguments, m_folder.path());
  }
  tool::RunResult shell(const std::string& command) {
    return tool::run_program({"/bin/sh", "-c", command}, m_folder.path());
  }
  fs::path path(const std::string& name) const { return m_folder / name; }
  bool exists(const std::string& name) const { return fs::exists(path(name)); }

 private:
  tool::TemporaryFolder m_folder;
};

/// What the levels leave out: quick colours, patterns, layers, normals, glass, mirrors, shadows.
const char* kQualityScene = R"(#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 }
camera { location <0, 2, -6> look_at <0, 0.5, 0> angle 50 }
light_source { <5, 8, -5> rgb 1 area_light <2, 0, 0>, <0, 0, 2>, 3, 3 }
light_source { <-5, 8, -5> rgb 0.4 }
background { rgb <0.2, 0.3, 0.6> }
plane { y, 0 pigment { checker rgb 1, rgb <0.6, 0.1, 0.1> }
  finish { reflection 0.3 conserve_energy ambient 0.2 emission 0.05 } }
sphere { <-1.2, 1, 0>, 1 pigment { gradient y color_map { [0 rgb x][1 rgb y] }
  quick_color rgb <1, 1, 0> } finish { phong 1 } normal { bumps 0.5 scale 0.2 } }
sphere { <1.2, 1, 0>, 1 pigment { rgbf <1, 0.9, 0.8, 0.8> } interior { ior 1.4 }
  finish { reflection 0.1 conserve_energy } }
box { <-0.4, 0, -2>, <0.4, 0.8, -1.4> texture { pigment { rgb <0, 0, 1> } }
  texture { pigment { rgbt <1, 1, 1, 0.5> } finish { ambient 0.3 } } rotate 20*y }
box { <0.9, 0, -2>, <1.5, 0.5, -1.4> texture { gradient x texture_map {
  [0.3 pigment { rgbft <0.2, 0.4, 0.8, 0.5, 0.3> }] [0.7 pigment { rgb <0.9, 0.8, 0> }
  normal { wrinkles 1 scale 0.1 } finish { specular 0.5 }] } } interior { ior 1.2 } }
)";

class ImageProgramQuality : public ::testing::TestWithParam<int> {};

TEST_P(ImageProgramQuality, IsStocks) {
  const SceneText scene{.sdl = kQualityScene,
                        .width = 120,
                        .height = 90,
                        .arguments = {"+Q" + std::to_string(GetParam())},
                        .files = {}};
  EXPECT_TRUE(same_as_stock(scene, Grade::exact));
}
INSTANTIATE_TEST_SUITE_P(Levels, ImageProgramQuality, ::testing::Range(0, 12));

TEST_F(ImageProgram, DefaultNameAndFolders) {
  fs::create_directory(path("out"));
  EXPECT_EQ(lentray({"scene.pov", "+W16", "+H12", "-V"}).status, 0);
  EXPECT_TRUE(exists("scene.png"));
  EXPECT_EQ(lentray({"+Iscene", "+W16", "+H12", "-V", "+Oout/", "+FE"}).status, 0);
  EXPECT_TRUE(exists("out/scene.exr"));
  EXPECT_EQ(lentray({"scene.pov", "+W16", "+H12", "-V", "+Ox.tif"}).status, 0);
  EXPECT_EQ(core::read_image(path("x.tif")).width, 16u);
  fs::remove(path("scene.png"));
  EXPECT_EQ(lentray({"scene.pov", "+W16", "+H12", "-V", "-F"}).status, 0);
  EXPECT_FALSE(exists("scene.png"));
}

TEST(ImageProgramStill, IsNoFrameOfAnAnimation) {
  const SceneText scene{.sdl =
                            "#version 3.7; global_settings { assumed_gamma 1 }\n"
                            "camera { location -5*z } light_source { -9*z, 1 }\n"
                            "sphere { <frame_number, clock_on, 0>, 1 pigment { rgb <1,.5,.2> } }",
                        .arguments = {},
                        .files = {}};
  EXPECT_TRUE(same_as_stock(scene, Grade::exact));
}

TEST_F(ImageProgram, StandardInputAndOutput) {
  ASSERT_EQ(lentray({"scene.pov", "+W16", "+H12", "-V", "+Ofile.png"}).status, 0);
  const auto result =
      shell("'" + program("lentray").string() + "' +I- +O- +W16 +H12 -V < scene.pov > piped.png");
  ASSERT_EQ(result.status, 0) << result.output;
  EXPECT_TRUE(same_bits(core::read_image(path("piped.png")), core::read_image(path("file.png"))));
}

TEST_F(ImageProgram, IniFilesWithSections) {
  tool::write_text(path("job.ini"),
                   "Input_File_Name=scene.pov\n+W9 +H7\n[large]\nInput_File_Name=scene.pov\n"
                   "Width=20\nHeight=10\nOutput_File_Name=large.png\n");
  EXPECT_EQ(lentray({"job", "-V"}).status, 0);
  EXPECT_EQ(core::read_image(path("scene.png")).width, 9u);
  EXPECT_EQ(lentray({"job[Large]", "-V", "+H11"}).status, 0);
  EXPECT_EQ(core::read_image(path("large.png")).width, 20u);
  EXPECT_EQ(core::read_image(path("large.png")).height, 11u);
}

TEST_F(ImageProgram, DeclareReachesTheScene) {
  tool::write_text(path("d.pov"),
                   "#version 3.7; global_settings { assumed_gamma 1 } background { rgb Grey }\n");
  EXPECT_EQ(lentray({"d.pov", "+W2", "+H2", "-V", "Declare=Grey=1", "File_Gamma=1"}).status, 0);
  EXPECT_EQ(core::read_image(path("d.png")).at(0, 0, 0), 255.0f);
}

TEST_F(ImageProgram, AViewIsTheSameColumnOfEveryLens) {
  const std::vector<std::string> common{"scene.pov", "+W150", "+H20", "-V", "Lenticular=On"};
  auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), common.begin(), common.end());
    return lentray(more);
  };
  ASSERT_EQ(with({"+Owhole.png"}).status, 0);
  ASSERT_EQ(with({"+Oview.png", "View=3"}).status, 0);
  const auto whole = core::read_image(path("whole.png")), view = core::read_image(path("view.png"));
  ASSERT_EQ(view.width, 10u);
  ASSERT_EQ(view.height, 20u);
  for (std::uint32_t row = 0; row < 20; ++row) {
    for (std::uint32_t i = 0; i < 10; ++i) {
      for (int c = 0; c < 3; ++c) EXPECT_EQ(view.at(i, row, c), whole.at(i * 15 + 3, row, c));
    }
  }
  const auto beyond = with({"View=15"});
  EXPECT_EQ(beyond.status, 1);
  EXPECT_NE(beyond.output.find("there is no view 15: the views are 0 to 14"), std::string::npos);
  EXPECT_EQ(with({"View=1", "Lens_Pixels=7.5"}).status, 0);  // tests/image/views_test.cpp
}

TEST_F(ImageProgram, TheMiddleViewIsTheOrdinaryPicture) {
  ASSERT_EQ(lentray({"scene.pov", "+W40", "+H30", "-V", "+Oplain.png"}).status, 0);
  ASSERT_EQ(
      lentray({"scene.pov", "+W600", "+H30", "-V", "+Oview.png", "Lenticular=On", "View=7"}).status,
      0);
  const auto comparison = core::read_image(path("view.png"));
  EXPECT_TRUE(reaches(comparison, core::read_image(path("plain.png")), Grade::exact));
}

TEST_F(ImageProgram, StatisticsAndMetadataTellTheLens) {
  ASSERT_EQ(lentray({"scene.pov", "+W150", "+H20", "-V", "Lenticular=On", "Lens_Pixels=7.5",
                     "Statistics_File=s.json"})
                .status,
            0);
  const auto json = nlohmann::json::parse(tool::read_text(path("s.json")));
  EXPECT_EQ(json["image"]["width"], 150);
  EXPECT_EQ(json["image"]["working_gamma"], 1.0);
  EXPECT_EQ(json["lens"]["pixels"], 7.5);
  EXPECT_EQ(json["lens"]["views"], 0);
  EXPECT_EQ(json["lens"]["model"], "paraxial");
  EXPECT_EQ(json["rays"]["camera"], 3000);
  EXPECT_GT(json["shadow"]["rays"], 0);
  EXPECT_EQ(json["lights"].size(), 2u);
  EXPECT_GT(json["tests"]["primitives"], 0);
  EXPECT_GT(json["memory"]["peak_bytes"], 1000000);
  const auto picture = core::read_image(path("scene.png"));
  bool found = false;
  for (const auto& [name, value] : picture.attributes) {
    found = found || (name.find("lens.pixels") != std::string::npos && value == "7.5");
  }
  EXPECT_TRUE(found);
}

TEST_F(ImageProgram, ExplainNamesWhatIsNeeded) {
  const auto result = lentray({"scene.pov", "--explain"});
  EXPECT_EQ(result.status, 0);
  EXPECT_NE(result.output.find("reflection"), std::string::npos);
  EXPECT_NE(result.output.find("2 sphere"), std::string::npos);
  EXPECT_NE(result.output.find("not needed"), std::string::npos);
  EXPECT_NE(result.output.find("Light buffers"), std::string::npos);
  EXPECT_FALSE(exists("scene.png"));
}

TEST_F(ImageProgram, WhatAPictureWillLackIsSaidBeforeItIsRendered) {
  tool::write_text(path("lacks.pov"),
                   "#version 3.7; global_settings { assumed_gamma 1 } light_source { -9*z, 1 }\n"
                   "sphere { 5*z, 1 pigment { image_map { function 0, 2 { x } } } }\n");
  const std::string text = lentray({"lacks.pov", "+W16", "+H12"}).output;
  EXPECT_LT(text.find("left out of the picture: image 'function'"), text.find("Rendering: 100%"))
      << text;
  for (const bool parses : {false, true}) {
    std::vector<std::string> arguments{"lacks.pov", "+W16", "+H12", "Strict=On", "+Ostrict.png"};
    if (parses) arguments.push_back("--parse-only");
    const auto strict = lentray(arguments);
    EXPECT_EQ(strict.status, 1);
    EXPECT_NE(strict.output.find("Strict=On: the picture would lack image 'function'"),
              std::string::npos)
        << strict.output;
    EXPECT_FALSE(exists("strict.png"));
  }
  EXPECT_EQ(lentray({"scene.pov", "+W16", "+H12", "Strict=On"}).status, 0);
}

TEST_F(ImageProgram, ASummaryAtTheEnd) {
  const std::string text = lentray({"scene.pov", "+W16", "+H12", "+A0.1"}).output;
  for (const char* part : {"Pixels:  192, antialiased ", "Rays:    camera ", "Seconds: reading ",
                           "Memory:  ", "scene.png: 16 x 12 pixels in "}) {
    EXPECT_NE(text.find(part), std::string::npos) << text;
  }
  EXPECT_EQ(text.find("Bands"), std::string::npos);
  lentray({"scene.pov", "+W16", "+H12", "-V", "Statistic_File=stats.txt"});
  EXPECT_TRUE(exists("stats.txt"));
}

TEST_F(ImageProgram, ProgressOnlyWhenWanted) {
  EXPECT_NE(lentray({"scene.pov", "+W16", "+H12"}).output.find("Rendering: 100%"),
            std::string::npos);
  EXPECT_EQ(lentray({"scene.pov", "+W16", "+H12", "-V"}).output, "");
}

TEST_F(ImageProgram, WhenStoppedItLeavesNothing) {
  // Stopped as soon as it is known to render.
  const auto result = shell("'" + program("lentray").string() +
                            "' scene.pov +W3000 +H2000 +WT1 2> log & p=$!; i=0; "
                            "while ! grep -q Rendering log && [ $i -lt 600 ]; do sleep 0.1; "
                            "i=$((i + 1)); done; kill -TERM $p; wait $p; s=$?; cat log; exit $s");
  EXPECT_EQ(result.status, 2) << result.output;
  EXPECT_NE(result.output.find("the picture was not written"), std::string::npos);
  EXPECT_FALSE(exists("scene.png"));
}

TEST_F(ImageProgram, ToolsTellOfThemselves) {
  for (const std::string tool :
       {"lentray-batch", "lentray-chart", "lentray-diff", "lentray-grouping", "lentray-merge",
        "lentray-model", "lentray-print", "lentray-views"}) {
    if (!std::filesystem::exists(program(tool))) continue;  // the study's may be left out
    const auto said = [&](const std::string& words, int status) {
      const auto result = shell("'" + program(tool).string() + "' " + words);
      EXPECT_EQ(result.status, status) << tool << words << result.output;
      return result.output;
    };
    EXPECT_EQ(said("a --help", 0).find("usage: " + tool), 0u) << tool;
    EXPECT_EQ(said("--no-such-option --version", 0), tool + " " + tool::kVersion + "\n");
    EXPECT_EQ(said("--no-such-option", tool == "lentray-diff" || tool == "lentray-batch" ? 2 : 1)
                  .find(tool + ": "),
              0u);
  }
  for (const std::string tool : {"lentray-diff", "lentray-batch"}) {
    const auto result = shell("'" + program(tool).string() + "'");
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.output.find("usage: " + tool), 0u) << result.output;
  }
}

TEST_F(ImageProgram, HelpAndVersion) {
  EXPECT_NE(lentray({"--help"}).output.find("usage: lentray"), std::string::npos);
  EXPECT_NE(lentray({"--version"}).output.find("Lentray "), std::string::npos);
}

class ErrorProgram : public ImageProgram {
 protected:
  void expect(const std::vector<std::string>& arguments, const std::string& part) {
    const auto result = lentray(arguments);
    EXPECT_EQ(result.status, 1);
    EXPECT_NE(result.output.find(part), std::string::npos) << result.output;
  }
};

TEST_F(ErrorProgram, OptionsThatAreNotThereYet) {
  expect({"scene.pov", "Real_Time_Raytracing=on"}, "not yet: real-time raytracing");
}

TEST_F(ErrorProgram, NoSceneAtAll) { expect({"+W10"}, "no scene was named"); }

TEST_F(ErrorProgram, CamerasWithoutASheet) {
  tool::write_text(path("f.pov"), "#version 3.7;\ncamera { fisheye angle 90 }\n");
  expect({"f.pov", "Lenticular=On", "+W30", "+H20"}, "a `fisheye` camera has no lens sheet");
}

TEST_F(ErrorProgram, ContradictoryLens) {
  expect({"scene.pov", "Lenticular=On", "Lens_Pixels=15", "Print_DPI=100"}, "contradict");
  expect({"scene.pov", "View=3"}, "needs a lens sheet");
  expect(
      {"scene.pov", "Lenticular=On", "Lens_Model=thick", "Lens_Pitch=3", "Lens_Focal_Length=3.03"},
      "there is no such lens: its surface would have a radius of 1.13625 mm");
}

}  // namespace
}  // namespace lentray::test
