// Ready pictures for a lens sheet by lentray-views: what the file says of the sheet beside what lentray says of the same
// one, which eye sees which picture, what is refused, and moving pictures.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "tests/support/render.h"
#include "tools/common/sheet_facts.h"

namespace lentray::test {
namespace {

constexpr const char* kReadyScene = R"(#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0,0,-5> look_at 0 right x*image_width/image_height }
background { rgb <clock, 0, 1 - clock> }
sphere { <0.6,0,1.5>, 0.9 pigment { rgb 1 } finish { ambient 1 diffuse 0 } }
)";

class ImageReadyPictures : public ::testing::Test {
 protected:
  void SetUp() override {
    tool::write_text(m_folder / "a.pov", kReadyScene);
    for (const std::string number : {"0", "1"})
      render("f" + number + ".png", {"+W40", "+H30", "+K" + number});
  }
  void render(const std::string& picture, std::vector<std::string> words) const {
    words.insert(words.begin(), {"+Ia.pov", "-V", "+O" + picture});
    const auto result = run_lentray(words, m_folder.path());
    ASSERT_EQ(result.status, 0) << result.output;
  }
  tool::RunResult run(const std::string& name, std::vector<std::string> words) const {
    words.insert(words.begin(), program(name).string());
    return tool::run_program(words, m_folder.path(), 100);
  }
  std::string views(const std::vector<std::string>& words, int status = 0) const {
    const auto result = run("lentray-views", words);
    EXPECT_EQ(result.status, status) << result.output;
    return result.output;
  }
  /// Red and blue behind the middle of a picture's upper edge.
  std::pair<float, float> colour(const std::string& name) const {
    const StoredImage image = core::read_image(m_folder / name);
    return {image.at(image.width / 2, 0, 0), image.at(image.width / 2, 0, 2)};
  }

  const tool::TemporaryFolder m_folder;
};
using ErrorReadyPictures = ImageReadyPictures;

/// All that lentray says of the sheet and the print of the same data, and the same pixels.
TEST_F(ImageReadyPictures, TheFileSaysTheSheetAsLentraySaysIt) {
  const char* kKeys[] = {"pitch_mm",
                         "focal_length_mm",
                         "ior",
                         "pixels",
                         "view_distance_mm",
                         "model",
                         "print_pitch_mm",
                         "lpi",
                         "lenses",
                         "views",
                         "sheet_width_mm",
                         "sheet_height_mm",
                         "print_width_mm",
                         "print_height_mm",
                         "print_dpi_x",
                         "print_dpi_y",
                         "paraxial_error_px",
                         "eye_miss_px"};
  tool::write_text(m_folder / "lens_sheets.ini", "[our 40]\nLens_LPI=39.9\nLens_Thickness=0.9mm\n");
  struct ReadyCase {
    std::vector<std::string> views, lentray;
  };
  const ReadyCase cases[] = {
      {{"--lens-sheet", "40lpi", "--dpi", "200", "--size", "30x24mm", "--view-distance", "40cm"},
       {"Lens_Sheet=40lpi", "Print_DPI=200", "Sheet_Width=30", "Sheet_Height=24",
        "View_Distance=400"}},
      {{"--lens-sheet", "our 40", "--dpi", "240x120", "--size", "30x24mm", "--view-distance",
        "inf"},
       {"Lens_Sheet=our 40", "Print_DPI=240x120", "Sheet_Width=30", "Sheet_Height=24",
        "View_Distance=inf"}},
      {{"--print-lpi", "39.8", "--lens-thickness", "1.9mm", "--lens-ior", "1.57", "--dpi", "200",
        "--size", "30x24mm", "--view-distance", "400", "--lens-model", "thick"},
       {"Print_LPI=39.8", "Lens_Thickness=1.9", "Lens_IOR=1.57", "Print_DPI=200", "Sheet_Width=30",
        "Sheet_Height=24", "View_Distance=400", "Lens_Model=thick"}},
      {{"--lpi", "40", "--lens-pixels", "6", "--size", "240x100", "--view-distance", "inf"},
       {"Lens_LPI=40", "Lens_Pixels=6", "+W240", "+H100", "View_Distance=inf"}}};
  for (const ReadyCase& one : cases) {
    std::vector<std::string> ready{"--interlace", "f0.png", "f1.png", "--out", "ready.png"};
    ready.insert(ready.end(), one.views.begin(), one.views.end());
    const std::string said = views(ready);
    std::vector<std::string> rendered{"Lenticular=On", "+Q0", "-A"};
    rendered.insert(rendered.end(), one.lentray.begin(), one.lentray.end());
    render("rendered.png", rendered);
    const StoredImage a = core::read_image(m_folder / "ready.png"),
                      b = core::read_image(m_folder / "rendered.png");
    EXPECT_EQ(a.width, b.width) << said;
    EXPECT_EQ(a.height, b.height) << said;
    const tool::Facts of_a = tool::facts_of(a), of_b = tool::facts_of(b);
    for (const std::string key : kKeys) {
      const auto told = of_a.find("lens." + key), wanted = of_b.find("lens." + key);
      ASSERT_NE(told, of_a.end()) << key;
      ASSERT_NE(wanted, of_b.end()) << key;
      const double value = tool::number_of(of_b, "lens." + key);
      if (key == "model") {
        EXPECT_EQ(told->second, wanted->second);
      }
      // What depends on the height of the scene's picture differs: that of a sheet in pixels is its own.
      EXPECT_NEAR(tool::number_of(of_a, "lens." + key), value, 1e-9 * std::fabs(value)) << key;
    }
    EXPECT_EQ(tool::number_of(a.attributes, "XResolution"),
              tool::number_of(b.attributes, "XResolution"));
    EXPECT_EQ(tool::number_of(a.attributes, "YResolution"),
              tool::number_of(b.attributes, "YResolution"));
    // Nothing else is asked for.
    views({"ready.png", "--eye", "3", "--out", "eye.png"});
    views({"ready.png", "--preview", "page.html"});
    EXPECT_EQ(run("lentray-print", {"sheet", "ready.png", "--out", "page.pdf"}).status, 0);
  }
}

/// The eyes that the line names see the pictures that it names.
TEST_F(ImageReadyPictures, EyesSeeThePicturesInTheOrderThatIsSaid) {
  for (const bool from_left : {false, true}) {
    std::vector<std::string> words{"--interlace", "f0.png", "f1.png",  "--lens-sheet",
                                   "40lpi",       "--dpi",  "600",     "--size",
                                   "30x24mm",     "--out",  "flip.png"};
    if (from_left) words.emplace_back("--from-left");
    const std::string said = views(words);
    const std::string first = from_left ? "left" : "right";
    EXPECT_NE(said.find("'f0.png', is seen from the " + first), std::string::npos) << said;
    EXPECT_NE(said.find(first + " edge turns away"), std::string::npos) << said;
    views({"flip.png", "--eye", "12", "--out", "right.png"});
    views({"flip.png", "--eye=-12", "--out", "left.png"});
    const auto right = colour("right.png"), left = colour("left.png");
    EXPECT_GT(from_left ? right.first : right.second, 200.0f) << said;
    EXPECT_GT(from_left ? left.second : left.first, 200.0f) << said;
  }
}

TEST_F(ErrorReadyPictures, SheetsThatAreNotSaid) {
  views({"--interlace", "f0.png", "f1.png", "--lens-sheet", "40lpi", "--dpi", "600", "--size",
         "20x15mm", "--out", "sheet.png"});
  struct ReadyCase {
    std::vector<std::string> words;
    const char* part;
  };
  const ReadyCase cases[] = {
      {{"--lens-sheet", "40lp", "--dpi", "600", "--size", "20x15mm"}, "did you mean 40lpi?"},
      {{"--lens-sheet", "40lpi", "--size", "20x15mm"}, "with --dpi D"},
      {{"--lens-sheet", "40lpi", "--dpi", "600"}, "--size 100x75mm"},
      {{"--lens-pixels", "12", "--size", "20x15mm"}, "needs --lens-sheet, --lpi or --dpi"},
      {{"--like", "sheet.png", "--lpi", "40"}, "--like says which lens sheet it is"},
      {{"--lens-pixels", "12", "--lpi", "40", "--dpi", "600", "--size", "20x15mm"},
       "contradict each other"},
      {{"--lens-sheet", "40lpi", "--lens-pixels", "600", "--size", "9000x15mm"},
       "a million each way"}};
  for (const ReadyCase& one : cases) {
    std::vector<std::string> words{"--interlace", "f0.png", "f1.png", "--out", "none.png"};
    words.insert(words.end(), one.words.begin(), one.words.end());
    const std::string said = views(words, 1);
    EXPECT_NE(said.find(one.part), std::string::npos) << said;
  }
  EXPECT_FALSE(std::filesystem::exists(m_folder / "none.png"));
  EXPECT_NE(views({"--lens-sheet", "list"}).find("40lpi"), std::string::npos);
}

/// Strips are not torn apart unless that is asked for; what was taken out of a sheet is a picture as any.
TEST_F(ErrorReadyPictures, IntegralImagesAreNoPictures) {
  views({"--interlace", "f0.png", "f1.png", "--lens-sheet", "40lpi", "--dpi", "600", "--size",
         "20x15mm", "--out", "sheet.png"});
  const std::vector<std::string> again{"--interlace", "sheet.png", "sheet.png", "--lens-pixels",
                                       "4",           "--out",     "torn.png"};
  const std::string said = views(again, 1);
  EXPECT_NE(said.find("'sheet.png' is an integral image already"), std::string::npos) << said;
  EXPECT_NE(said.find("--all takes its views out of it"), std::string::npos) << said;
  EXPECT_FALSE(std::filesystem::exists(m_folder / "torn.png"));
  std::vector<std::string> insisted = again;
  insisted.emplace_back("--take-any");
  views(insisted);
  EXPECT_TRUE(std::filesystem::exists(m_folder / "torn.png"));
  views({"sheet.png", "--all", "--out", "v##.png"});
  views({"--interlace", "v00.png", "v14.png", "--lens-pixels", "4", "--out", "again.png"});
  views({"sheet.png", "--eye", "4", "--out", "e.png"});
  views({"--interlace", "e.png", "e.png", "--lens-pixels", "4", "--out", "again.png"});
}

TEST_F(ImageReadyPictures, PicturesOfAnotherShapeAreStretchedWithAWarning) {
  const std::vector<std::string> sheet{"--lens-sheet", "40lpi", "--dpi", "200", "--out", "s.png"};
  const auto with = [&](const char* size) {
    std::vector<std::string> words{"--interlace", "f0.png", "f1.png", "--size", size};
    words.insert(words.end(), sheet.begin(), sheet.end());
    return views(words);
  };
  EXPECT_EQ(with("40x30mm").find("warning"), std::string::npos);
  EXPECT_NE(with("40x20mm").find("'f0.png' is 1.333 times as wide as high, the sheet 1.994 times"),
            std::string::npos)
      << with("40x20mm");
}

/// A sheet's frames are as it looks, not a pixel a lens; an animation begins anew after its last phase.
TEST_F(ImageReadyPictures, MovingPictures) {
  const std::vector<std::string> sheet{"--interlace", "f0.png",        "f1.png", "--lens-sheet",
                                       "40lpi",       "--lens-pixels", "4",      "--size",
                                       "120x90mm",    "--out"};
  std::vector<std::string> words = sheet;
  words.emplace_back("sway.png");
  views(words);
  EXPECT_EQ(views({"sway.png", "--wiggle", "a.gif"}), "a.gif: 6 frames of 640 x 480 pixels\n");
  EXPECT_EQ(views({"sway.png", "--wiggle", "a.gif", "--motion", "loop"}),
            "a.gif: 4 frames of 640 x 480 pixels\n");
  words = sheet;
  words.insert(words.end(), {"loop.png", "--motion", "loop"});
  views(words);
  EXPECT_EQ(views({"loop.png", "--wiggle", "a.gif"}), "a.gif: 4 frames of 640 x 480 pixels\n");
  EXPECT_EQ(views({"loop.png", "--wiggle", "a.gif", "--motion", "sway", "--size", "40x30"}),
            "a.gif: 6 frames of 40 x 30 pixels\n");
  EXPECT_NE(views({"loop.png", "--wiggle", "a.gif", "--motion", "round"}, 1).find("sway and loop"),
            std::string::npos);
}

TEST_F(ImageReadyPictures, QuiltsMove) {
  render("q.png", {"Quilt=3x2", "Quilt_Tile=40x30", "View_Cone=60"});
  const char* const moving = ": 10 frames of 40 x 30 pixels\n";
  EXPECT_EQ(views({"q.png", "--wiggle", "a.png"}), "a.png" + std::string(moving));
  // The first frame is that of the rightmost camera, the quilt's upper right tile.
  const StoredImage quilt = core::read_image(m_folder / "q.png"),
                    frame = core::read_image(m_folder / "a.png");
  for (std::uint32_t x = 0; x < 40; ++x) {
    for (std::uint32_t y = 0; y < 30; ++y)
      ASSERT_EQ(frame.at(x, y, 1), quilt.at(80 + x, y, 1)) << x << " " << y;
  }
  // By its name alone, and of another shape than its pixels.
  const auto plain =
      tool::run_program({"oiiotool", "q.png", "--eraseattrib", ".*", "-o", "b_qs3x2a0.6667.png"},
                        m_folder.path(), 100);
  ASSERT_EQ(plain.status, 0) << plain.output;
  EXPECT_EQ(views({"b_qs3x2a0.6667.png", "--wiggle", "a.png"}),
            "a.png: 10 frames of 40 x 60 pixels\n");
  std::filesystem::rename(m_folder / "b_qs3x2a0.6667.png", m_folder / "b_qs7x2.png");
  EXPECT_NE(views({"b_qs7x2.png", "--wiggle", "a.png"}, 1).find("no 7 x 2 tiles"),
            std::string::npos);
}

TEST_F(ImageReadyPictures, APitchTestSaysWhereItsNumberGoes) {
  const auto result =
      run("lentray-print", {"pitch-test", "--lpi", "40", "--dpi", "200", "--out", "p.pdf"});
  ASSERT_EQ(result.status, 0) << result.output;
  const std::size_t render = result.output.find("Print_LPI="), fit = result.output.find("--pitch");
  ASSERT_NE(render, std::string::npos) << result.output;
  ASSERT_NE(fit, std::string::npos) << result.output;
  EXPECT_LT(render, fit);
}

}  // namespace
}  // namespace lentray::test
