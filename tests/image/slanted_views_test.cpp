// Views of slanted lens sheets: taken out of a sheet by a few lines of their own, by lentray-views, as
// rendered, and as stock's own camera sees them; and what the programs refuse.
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "core/image/reader.h"
#include "tests/image/slanted_scenes.h"
#include "tools/common/process.h"

namespace lentray::test::slanted {
namespace {

/// The pixel of view j of `views` at place i of a row, by counting: of the lens whose axis is nearest
/// to the place, the pixel whose middle is nearest to the view's offset.
int column_of_view(const SlantReference& s, int view, int views, int place, int row) {
  const double tangent = std::tan(static_cast<double>(s.angle()));
  const double up = (0.5 * s.rows - row - 0.5) * s.row_by_column * tangent;  // columns
  const double lens = std::round(place - up / s.pixels);
  double least = 1e9;
  int nearest = -1;
  for (int k = 0; k < s.columns; ++k) {
    const double at = (k + 0.5 - up) / s.pixels - lens - (view + 0.5) / views;
    if (std::fabs(at) < least) least = std::fabs(at), nearest = k;
  }
  return nearest;
}

class ImageSlantedViews : public ::testing::Test {
 protected:
  void SetUp() override {
    tool::write_text(m_folder / "scene.pov", sheet_scene(m_sheet));
    render("sheet.png", {});
  }
  tool::RunResult render(const std::string& name, std::vector<std::string> more) {
    std::vector<std::string> arguments{"+Iscene.pov", "+O" + name, "-V",
                                       "+W" + std::to_string(m_sheet.columns),
                                       "+H" + std::to_string(m_sheet.rows)};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const tool::RunResult result = run_lentray(arguments, m_folder.path());
    EXPECT_EQ(result.status, 0) << result.output;
    return result;
  }
  tool::RunResult run(const std::string& tool, const std::vector<std::string>& arguments) {
    std::vector<std::string> words = arguments;
    words.insert(words.begin(), program(tool).string());
    return tool::run_program(words, m_folder.path());
  }
  StoredImage picture(const std::string& name) { return core::read_image(m_folder / name); }

  /// tan a = 0.3, pixels higher than wide, and an N with which no place hangs between two pixels.
  SlantReference m_sheet{.model = Model::kParaxial,
                         .slant = 16.69924423399362,
                         .pixels = 7.3713,
                         .distance = 300.0,
                         .columns = 118,
                         .rows = 36,
                         .row_by_column = 1.5};
  tool::TemporaryFolder m_folder;
};
using ErrorSlantedViews = ImageSlantedViews;

TEST_F(ImageSlantedViews, TakenOutTheyAreTheRenderedOnes) {
  const StoredImage sheet = picture("sheet.png");
  for (const int view : {0, 3, 6}) {
    const std::string j = std::to_string(view);
    render("view.png", {"View=" + j});
    const auto result = run("lentray-views", {"sheet.png", "--view", j, "--out", "taken.png"});
    ASSERT_EQ(result.status, 0) << result.output;
    const StoredImage rendered = picture("view.png"), taken = picture("taken.png");
    ASSERT_EQ(rendered.width, 16u);
    EXPECT_TRUE(reaches(taken, rendered, Grade::exact));
    for (int row = 0; row < m_sheet.rows; ++row) {
      for (int i = 1; i < 15; ++i) {
        const int k = column_of_view(m_sheet, view, 7, i, row);
        EXPECT_EQ(
            core::level(taken, static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(row)),
            core::level(sheet, static_cast<std::uint32_t>(k), static_cast<std::uint32_t>(row)))
            << view << ' ' << i << ' ' << row;
      }
    }
  }
}

/// A view in any size is what stock's own camera sees from the view's eye.
TEST_F(ImageSlantedViews, PicturesOfViewsAreStocks) {
  for (const int view : {0, 2}) {
    const StoredImage ours =
        lentray_render(text_of(sheet_scene(m_sheet), m_sheet.columns, m_sheet.rows),
                       {"Views=4", "View=" + std::to_string(view), "View_Size=80x45"});
    const SlantReal e =
        ((view + 0.5L) / 4 - 0.5L) * m_sheet.print_pitch() / std::cos(m_sheet.angle());
    const SlantReal aside = m_sheet.ior * e / m_sheet.focal_length;
    const SlantReal v = m_sheet.distance;
    std::ostringstream stock;
    // Rays of the sheet begin kFront before it; from the eye nothing stands in their way.
    stock << world_of(m_sheet) << "camera { location " << point({-v * aside, 0, -v})
          << " direction " << point({v * aside, 0, v}) << " right " << number(m_sheet.width())
          << "*x up " << number(m_sheet.height()) << "*y }\n";
    EXPECT_TRUE(reaches(ours, stock_render(text_of(stock.str(), 80, 45)), Grade::match));
  }
}

/// The eye of a view sees it through the sheet.
TEST_F(ImageSlantedViews, TheEyeOfAViewSeesIt) {
  const int view = 3;
  const double e = ((view + 0.5) / 7 - 0.5) * static_cast<double>(m_sheet.print_pitch()) /
                   std::cos(static_cast<double>(m_sheet.angle()));
  const double angle =
      -std::atan(m_sheet.ior * e / m_sheet.focal_length) * 180.0 / std::numbers::pi;
  const auto seen =
      run("lentray-views", {"sheet.png", "--eye", number(angle) + ",300", "--out", "eye.png"});
  ASSERT_EQ(seen.status, 0) << seen.output;
  run("lentray-views", {"sheet.png", "--view", "3", "--out", "view.png"});
  EXPECT_TRUE(reaches(picture("eye.png"), picture("view.png"), Grade::exact));
}

/// With as many views as a lens has pixels each pixel goes back to where it was.
TEST_F(ImageSlantedViews, InterlacedTheyAreTheSheet) {
  render("sheet.png", {"Lens_Pixels=7", "Lens_Slant=1/3"});
  ASSERT_EQ(run("lentray-views", {"sheet.png", "--all", "--out", "v#.png"}).status, 0);
  std::vector<std::string> words{"--interlace", "--like", "sheet.png", "--out", "again.png"};
  for (int view = 0; view < 7; ++view) words.push_back("v" + std::to_string(view) + ".png");
  const auto result = run("lentray-views", words);
  ASSERT_EQ(result.status, 0) << result.output;
  const StoredImage sheet = picture("sheet.png"), again = picture("again.png");
  ASSERT_EQ(again.width, sheet.width);
  for (std::uint32_t row = 0; row < sheet.height; ++row) {
    for (std::uint32_t k = 14; k + 14 < sheet.width; ++k) {  // lenses at the edges are cut
      EXPECT_EQ(core::level(again, k, row), core::level(sheet, k, row)) << k << ' ' << row;
    }
  }
  EXPECT_NE(run("lentray-views", {"again.png"}).output.find("slanted by 18.43 degrees"),
            std::string::npos);
  // The same without a sheet to go by; its pixels are 1.5 times as high as wide.
  words.erase(words.begin() + 1, words.begin() + 5);
  words.insert(words.end(), {"--out", "alone.png", "--lens-pixels", "7", "--lens-slant", "1/3",
                             "--size", "118x36", "--aspect", number(118.0 / 36.0 / 1.5)});
  const auto alone = run("lentray-views", words);
  ASSERT_EQ(alone.status, 0) << alone.output;
  EXPECT_TRUE(reaches(picture("alone.png"), again, Grade::exact));
}

TEST_F(ImageSlantedViews, AreSaidInTheFile) {
  const std::string said = run("lentray-views", {"sheet.png"}).output;
  EXPECT_NE(said.find("slanted by 16.7 degrees"), std::string::npos) << said;
  const std::string report = render("again.png", {"Lens_Slant=-1/6"}).output;
  EXPECT_NE(report.find("slanted by -9.462 degrees, a tangent of -0.1667: their tops lean to the "
                        "left"),
            std::string::npos)
      << report;
}

/// What has no lenses says that it takes no notice of a slant.
TEST_F(ErrorSlantedViews, OptionsThatDoNotGoTogether) {
  tool::write_text(m_folder / "plain.pov", world_of(m_sheet) + "camera { location <0,0,-20> }\n");
  const auto warning = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"plain.pov", "Lens_Slant=1/3", "+Oplain.png", "+W32", "+H24"});
    const auto result = run("lentray", more);
    EXPECT_EQ(result.status, 0) << result.output;
    return result.output;
  };
  EXPECT_NE(warning({}).find("the lens options have no effect without Lenticular=On"),
            std::string::npos);
  EXPECT_NE(
      warning({"Quilt=2x2", "Quilt_Tile=32x24"}).find("the lens options have no effect on a quilt"),
      std::string::npos);
}

TEST_F(ErrorSlantedViews, EveryMessage) {
  const auto expect = [&](const tool::RunResult& result, const char* message) {
    EXPECT_NE(result.status, 0) << message;
    EXPECT_NE(result.output.find(message), std::string::npos) << result.output;
    EXPECT_EQ(result.output.find("nan"), std::string::npos) << result.output;
  };
  expect(run("lentray-views", {"sheet.png", "--lens", "3"}),
         "'sheet.png' is for lenses slanted by 16.7 degrees: no columns lie behind one of them");
  expect(run("lentray-views", {"sheet.png", "--preview", "page.html"}),
         "'sheet.png' is for lenses slanted by 16.7 degrees: a page shows the views of upright");
  expect(run("lentray-views", {"sheet.png", "--view", "7"}), "there is no view 7");
  for (const char* bad : {"steep", "90", "1/0", "1e300"}) {
    expect(run("lentray-views", {"sheet.png", "--lens-slant", bad, "--view", "0"}),
           "an angle of -80 to 80 degrees (9.46) or its tangent as a fraction (1/6) is expected");
  }
  expect(run("lentray-print", {"sheet", "sheet.png", "--out", "page.pdf"}),
         "'sheet.png' is for lenses slanted by 16.6992 degrees; pages are for upright ones");
  expect(run_diff({(m_folder / "scene.pov").string(), "+W30", "+H20"}),
         "there is no reference for slanted lenses (Lens_Slant)");
}

}  // namespace
}  // namespace lentray::test::slanted
