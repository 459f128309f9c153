// --depth, --depth-view and Depth_Budget by the program: what is said, drawn and refused. Figures are held
// against every pixel in tests/image/depth_dense_test.cpp.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <regex>

#include "tests/image/depth_text.h"
#include "tests/support/render.h"

namespace lentray::test {
namespace {

namespace fs = std::filesystem;

constexpr const char* kDepthScene = R"(#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0,0,-5> look_at 0 right x*4/3 }
light_source { <5,8,-6> rgb 1 }
#declare Ball = sphere { <0.6,0,1.5>, 0.9 }
object { Ball pigment { rgb <1,0.6,0.1> } }
sphere { <-0.9,-0.3,-2.8>, 0.3 pigment { rgb <0.2,0.5,1> } }
union { box { <-1,-1,-0.1>, <-0.8,1,0.1> } box { <1,-1,0.5>, <1.2,1,0.7> } pigment { rgb 1 } }
)";

class ImageDepth : public ::testing::Test {
 protected:
  void SetUp() override { tool::write_text(m_folder / "a.pov", kDepthScene); }
  tool::RunResult lentray(std::vector<std::string> words,
                          const std::string& scene = "a.pov") const {
    words.insert(words.begin(), "+I" + scene);
    return run_lentray(words, m_folder.path());
  }
  tool::RunResult depth(std::vector<std::string> more, const std::string& scene = "a.pov") const {
    more.insert(more.begin(), {"Lenticular=On", "--depth"});
    return lentray(more, scene);
  }
  void expect_refused(const std::vector<std::string>& words, const std::string& part) const {
    const auto result = lentray(words);
    EXPECT_EQ(result.status, 1) << result.output;
    EXPECT_NE(result.output.find(part), std::string::npos) << result.output;
    for (const char* bad : {"nan", "inf "}) {
      EXPECT_EQ(result.output.find(bad), std::string::npos) << result.output;
    }
    EXPECT_FALSE(fs::exists(m_folder / "a.png"));
    EXPECT_FALSE(fs::exists(m_folder / "a.svg"));
  }
  std::string read(const std::string& name) const { return tool::read_text(m_folder / name); }

  const tool::TemporaryFolder m_folder;
};
using ErrorDepth = ImageDepth;

bool depth_says(const tool::RunResult& result, const std::string& part) {
  return result.output.find(part) != std::string::npos;
}

TEST_F(ImageDepth, NamesWhatStandsOutByItsPlace) {
  const auto result = depth({"+W600", "+H300", "Lens_Pixels=7"});
  ASSERT_EQ(result.status, 0) << result.output;
  for (const char* part :
       {"sphere at a.pov:7:1: 1.9 to 2.385 from the camera (Sheet_Distance=2.115), -",
        "Ball at a.pov:6:1: ", "; jumps", "Background, ",
        "Found with a ray through each of 180000 pixels",
        "Proposed, for all that is visible: Sheet_Distance="}) {
    EXPECT_TRUE(depth_says(result, part)) << part << "\n" << result.output;
  }
  // What a sheet cuts is named too, in every report.
  const auto cut = lentray({"Lenticular=On", "+W600", "+H300", "--explain"});
  EXPECT_TRUE(depth_says(cut, "the lens sheet cuts an object (box at a.pov:8:9)")) << cut.output;
  EXPECT_FALSE(fs::exists(m_folder / "a.png"));
}

TEST_F(ImageDepth, TheProposedDistanceHasTheFiguresThatWereTold) {
  const auto before = depth({"+W600", "+H300"});
  std::smatch found;
  const std::regex pattern(
      "Proposed, for all that is visible: Sheet_Distance=([0-9.]+) instead of 5: the nearest point "
      "would have (-[0-9.]+), "
      "the "
      "farthest ([0-9.]+) pixels a view");
  ASSERT_TRUE(std::regex_search(before.output, found, pattern)) << before.output;
  const double near = std::stod(found[2]), far = std::stod(found[3]);
  EXPECT_NEAR(near, -far, 0.01);
  const auto after = depth({"+W600", "+H300", "Sheet_Distance=" + found[1].str()});
  EXPECT_NEAR(parallax_behind(after.output, "Nearest visible point"), near, 0.03);
  EXPECT_NEAR(parallax_behind(after.output, "Farthest visible point"), far, 0.03);
}

TEST_F(ImageDepth, TheOtherCamerasHaveTheirReports) {
  const auto parallel = depth({"View_Distance=inf", "+W300", "+H100"});
  EXPECT_EQ(parallel.status, 0);
  EXPECT_TRUE(depth_says(parallel, "moves along with the eye")) << parallel.output;
  EXPECT_TRUE(depth_says(parallel, "Between outer views")) << parallel.output;
  std::string text = kDepthScene;
  text.replace(text.find("camera {"), 8, "camera { orthographic");
  tool::write_text(m_folder / "o.pov", text);
  const auto orthographic = depth({"+W300", "+H100", "Depth_Budget=0.5"}, "o.pov");
  EXPECT_EQ(orthographic.status, 0) << orthographic.output;
  EXPECT_TRUE(depth_says(orthographic, "Depth_Budget 0.5 pixels a view: depth is compressed to "))
      << orthographic.output;
  EXPECT_TRUE(depth_says(orthographic, "infinitely far and moves along")) << orthographic.output;
  text = kDepthScene;
  const std::size_t begin = text.find("camera {"), end = text.find('\n', begin);
  text.replace(begin, end - begin,
               "camera { lenticular location 0 direction z right x*4 up y*3 view_distance 80 }");
  tool::write_text(m_folder / "l.pov", text);
  const auto own = lentray({"--depth", "+W300", "+H100"}, "l.pov");
  EXPECT_EQ(own.status, 0) << own.output;
  EXPECT_TRUE(depth_says(own, "visible: the camera's location moved by ")) << own.output;
  for (const auto* result : {&parallel, &orthographic, &own}) {
    EXPECT_FALSE(depth_says(*result, "nan")) << result->output;
    EXPECT_FALSE(depth_says(*result, "inf ")) << result->output;
  }
}

/// Views, and quilts of the sheet's views, are pictures of the same eyes.
TEST_F(ImageDepth, ABudgetHoldsForSheetsViewsAndQuilts) {
  const std::vector<std::string> common{"Lenticular=On",    "Lens_Pixels=8", "+W320", "+H40",
                                        "Depth_Budget=0.3", "+FN",           "-V"};
  const auto render = [&](const std::vector<std::string>& more) {
    std::vector<std::string> words = common;
    words.insert(words.end(), more.begin(), more.end());
    const auto result = lentray(words);
    EXPECT_EQ(result.status, 0) << result.output;
  };
  render({"+Osheet.png"});
  render({"View=2", "+Oview.png"});
  const StoredImage sheet = core::read_image(m_folder / "sheet.png"),
                    view = core::read_image(m_folder / "view.png");
  ASSERT_EQ(view.width, 40u);
  for (std::uint32_t row = 0; row < 40; ++row) {
    for (std::uint32_t i = 0; i < 40; ++i) {
      for (int c = 0; c < 3; ++c) ASSERT_EQ(view.at(i, row, c), sheet.at(8 * i + 2, row, c));
    }
  }
  EXPECT_LT(std::stod(sheet.attributes.at("lentray:lens.depth_factor")), 0.5);
  EXPECT_EQ(sheet.attributes.at("lentray:lens.depth_factor"),
            view.attributes.at("lentray:lens.depth_factor"));
  for (const std::string model : {"pinhole", "thick"}) {
    render({"Lens_Model=" + model, "+O" + model + ".png", "+H10", "View_Distance=200"});
    EXPECT_LT(std::stod(core::read_image(m_folder / (model + ".png"))
                            .attributes.at("lentray:lens.depth_factor")),
              0.5);
  }
  // A quilt's eyes have an angle of their own, and pixels of a tile.
  const auto quilt = lentray({"Quilt=4x2", "Quilt_Tile=40x30", "Depth_Budget=0.3", "+Oq.png"});
  ASSERT_EQ(quilt.status, 0) << quilt.output;
  EXPECT_TRUE(depth_says(quilt, "Depth_Budget 0.3 pixels a view: depth is compressed to "))
      << quilt.output;
  const StoredImage tiles = core::read_image(m_folder / "q.png");
  EXPECT_LT(std::stod(tiles.attributes.at("lentray:quilt.depth_factor")), 1.0);
}

/// What lentray-diff asks of stock follows the factor.
TEST_F(ImageDepth, StockRendersTheSameCompressedSheet) {
  for (const std::string distance : {"View_Distance=60", "View_Distance=inf"}) {
    const auto result = run_diff({"a.pov", "Lenticular=On", "Lens_Pixels=5", "+W100", "+H30",
                                  "Lens_Model=paraxial", "Depth_Budget=0.4", distance},
                                 m_folder.path());
    EXPECT_EQ(result.status, 0) << result.output;
  }
}

TEST_F(ImageDepth, WithoutABudgetThePictureIsTheSame) {
  ASSERT_EQ(lentray({"Lenticular=On", "+W300", "+H50", "-V", "+Oa.png"}).status, 0);
  // A budget that nothing exceeds.
  ASSERT_EQ(
      lentray({"Lenticular=On", "+W300", "+H50", "-V", "+Ob.png", "Depth_Budget=1000"}).status, 0);
  EXPECT_TRUE(
      same_bits(core::read_image(m_folder / "a.png"), core::read_image(m_folder / "b.png")));
}

TEST_F(ImageDepth, TheViewFromAboveIsADrawing) {
  const auto result = lentray({"Lenticular=On", "+W300", "+H100", "--depth-view", "a.svg"});
  ASSERT_EQ(result.status, 0) << result.output;
  EXPECT_TRUE(depth_says(result, "Nearest visible point ")) << result.output;
  const std::string svg = read("a.svg");
  EXPECT_TRUE(svg.starts_with("<svg xmlns=")) << svg.substr(0, 60);
  for (const char* part : {"sphere at a.pov:7:1", "Ball at a.pov:6:1", "lens sheet", ">sharp<",
                           "class=\"zone\"", "class=\"eye\"", "</svg>"}) {
    EXPECT_NE(svg.find(part), svg.npos) << part;
  }
  for (const char* part : {"nan", "inf", "href", "http://www.w3.org/1999", "<script"}) {
    EXPECT_EQ(svg.find(part), svg.npos) << part;
  }
  // One programs can read, whatever things are called.
  tool::write_text(m_folder / "<&>.pov", kDepthScene);
  ASSERT_EQ(lentray({"Lenticular=On", "+W300", "+H100", "--depth-view=b.svg", "View_Distance=inf"},
                    "<&>.pov")
                .status,
            0);
  for (const char* name : {"a.svg", "b.svg"}) {
    const auto read = tool::run_program(
        {"python3", "-c", "import sys, xml.dom.minidom; xml.dom.minidom.parse(sys.argv[1])", name},
        m_folder.path(), 60);
    EXPECT_EQ(read.status, 0) << read.output;
  }
  EXPECT_NE(read("b.svg").find("&lt;&amp;&gt;.pov"), std::string::npos);
  const auto out = lentray({"Lenticular=On", "+W300", "+H100", "-V", "--depth-view", "-"});
  EXPECT_TRUE(depth_says(out, "<svg xmlns=")) << out.output;
  EXPECT_FALSE(depth_says(out, "Nearest visible point")) << out.output;
}

TEST_F(ImageDepth, ViewsOfASheetHaveOneReport) {
  const auto result =
      lentray({"Lenticular=On", "+W300", "+H100", "Views=3", "--depth-view", "v.svg"});
  ASSERT_EQ(result.status, 0) << result.output;
  const std::size_t first = result.output.find("Nearest visible point");
  EXPECT_NE(first, std::string::npos);
  EXPECT_EQ(result.output.find("Nearest visible point", first + 1), std::string::npos);
  EXPECT_TRUE(fs::exists(m_folder / "v.svg"));
}

TEST_F(ImageDepth, SomeViewsOfASheetHaveOneReportToo) {
  const auto result = lentray(
      {"Lenticular=On", "+W300", "+H100", "Views=15", "+SF5", "+EF9", "--depth-view", "v.svg"});
  ASSERT_EQ(result.status, 0) << result.output;
  const std::size_t first = result.output.find("Nearest visible point");
  EXPECT_NE(first, std::string::npos);
  EXPECT_EQ(result.output.find("Nearest visible point", first + 1), std::string::npos);
  EXPECT_TRUE(fs::exists(m_folder / "v.svg"));
}

TEST_F(ImageDepth, FramesAreWarnedOf) {
  const auto result = lentray({"Lenticular=On", "+W60", "+H10", "Depth_Budget=0.5", "+KFF2", "-V"});
  EXPECT_EQ(result.status, 0) << result.output;
  EXPECT_TRUE(depth_says(result, "Depth_Budget: each frame has its own factor")) << result.output;
}

TEST_F(ErrorDepth, NoSheetNoDepth) {
  expect_refused({"--depth"}, "--depth needs a lens sheet: add Lenticular=On");
  expect_refused({"--depth-view", "a.svg"}, "--depth needs a lens sheet: add Lenticular=On");
  expect_refused({"--depth", "Quilt=4x2", "Quilt_Tile=40x30"},
                 "the lenses of a quilt's display are not known");
  expect_refused({"Depth_Budget=1mm", "Quilt=4x2", "Quilt_Tile=40x30"},
                 "Depth_Budget in mm is of a print");
  expect_refused({"Lenticular=On", "--depth-view"}, "--depth-view needs the name of a file");
  expect_refused({"Lenticular=On", "--depth-view", "no/such/folder/a.svg"}, "no/such/folder");
  const auto plain = lentray({"Depth_Budget=1", "+W20", "+H10", "-V", "+Ob.png"});
  EXPECT_EQ(plain.status, 0);
  EXPECT_TRUE(depth_says(plain, "the lens options have no effect without Lenticular=On"));
}

TEST_F(ErrorDepth, BadBudgets) {
  expect_refused({"Lenticular=On", "Depth_Budget=0"}, "a parallax greater than 0 is expected");
  expect_refused({"Lenticular=On", "Depth_Budget=1e300"}, "at most a million pixels a view");
  expect_refused(
      {"Lenticular=On", "Depth_Budget=0.3", "Lens_Model=pinhole", "Lens_Pixels=8", "+W320"},
      "rays of neighbouring views part before a visible point");
  // So small that the eyes would be one.
  expect_refused({"Lenticular=On", "Depth_Budget=1e-300"}, "depth would be nothing");
}

}  // namespace
}  // namespace lentray::test
