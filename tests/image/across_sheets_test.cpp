// Lenses that lie across the upright picture: Lens_Direction=across. The pictures of views are those of stock with its
// camera moved up and down; files are on their side and say so; the programs take them apart, put them together and
// print them upright.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <regex>
#include <sstream>

#include "core/image/orientation.h"
#include "tests/support/render.h"
#include "tools/common/photo_reader.h"
#include "tools/common/sheet_facts.h"

namespace lentray::test {
namespace {

/// Depth on both sides of the sheet, which stands through the origin 5 before the eye.
constexpr const char* kAcrossScene = R"(#version 3.7;
global_settings { assumed_gamma 1 }
#ifndef (Camera) #declare Camera = camera { location <0,0,-5> look_at 0 right x*4/3 } #end
camera { Camera }
light_source { <5,8,-6> rgb 1 }
background { rgb <0.2,0.3,0.5> }
plane { y, -1.2 pigment { checker rgb 0.9 rgb <0.4,0.5,0.2> } }
sphere { <0.6,0,1.5>, 0.9 pigment { rgb <1,0.6,0.1> } finish { phong 0.4 } }
sphere { <-0.9,-0.3,-0.8>, 0.5 pigment { rgb <0.2,0.5,1> } }
)";

class ImageAcrossSheets : public ::testing::Test {
 protected:
  void SetUp() override { tool::write_text(m_folder / "a.pov", kAcrossScene); }

  tool::RunResult lentray(std::vector<std::string> words) const {
    words.insert(words.begin(), {"+Ia.pov", "-V", "Lenticular=On", "Lens_Direction=across"});
    return run_lentray(words, m_folder.path());
  }
  void render(const std::string& picture, std::vector<std::string> words) const {
    words.push_back("+O" + picture);
    const auto result = lentray(words);
    ASSERT_EQ(result.status, 0) << result.output;
  }
  std::string run(const std::string& name, std::vector<std::string> words, int status = 0) const {
    words.insert(words.begin(), program(name).string());
    const auto result = tool::run_program(words, m_folder.path(), 100);
    EXPECT_EQ(result.status, status) << result.output;
    return result.output;
  }
  StoredImage read(const std::string& name) const { return core::read_image(m_folder / name); }
  /// As it is looked at.
  StoredImage upright(const std::string& name) const {
    return tool::PhotoReader().read(m_folder / name);
  }
  static double number(const StoredImage& image, const std::string& name) {
    return tool::number_of(tool::facts_of(image), "lens." + name);
  }
  /// Every N-th row of a sheet with whole N.
  static StoredImage rows_of(const StoredImage& sheet, std::uint32_t first, std::uint32_t pixels) {
    std::vector<std::uint32_t> columns, rows;
    for (std::uint32_t x = 0; x < sheet.width; ++x) columns.push_back(x);
    for (std::uint32_t y = first; y < sheet.height; y += pixels) rows.push_back(y);
    return core::rearranged(sheet, columns, rows);
  }

  const tool::TemporaryFolder m_folder;
};
using ErrorAcrossSheets = ImageAcrossSheets;

/// The middle one is the scene's own picture, view 0 that of an eye below, the last one of an eye above.
TEST_F(ImageAcrossSheets, ViewsAreStocksPicturesFromBelowToAbove) {
  double before = -1e9;
  for (const int j : {0, 2, 4}) {
    render("view.png",
           {"Lens_Pixels=7.5", "Views=5", "View=" + std::to_string(j), "+W120", "+H90"});
    const StoredImage view = read("view.png");
    ASSERT_EQ(view.width, 120u);
    ASSERT_EQ(view.height, 90u);
    // In the scene's units V is 5.
    const double eye = 5.0 * number(view, "ior") * number(view, "view_offset_mm") /
                       number(view, "focal_length_mm");
    EXPECT_GT(eye, before);
    before = eye;
    char camera[200];
    std::snprintf(
        camera, sizeof camera,
        "#version 3.7; #declare Camera = camera { location <0,%.17g,-5> direction <0,%.17g,5> "
        "right x*20/3 up y*5 }\n",
        eye, -eye);
    const SceneText scene{.sdl = camera + std::string(kAcrossScene),
                          .width = 120,
                          .height = 90,
                          .arguments = {},
                          .files = {}};
    EXPECT_TRUE(reaches(view, stock_render(scene), Grade::exact)) << j;
    if (j != 2) continue;
    EXPECT_NEAR(eye, 0.0, 1e-9);
    const SceneText plain{
        .sdl = kAcrossScene, .width = 120, .height = 90, .arguments = {}, .files = {}};
    EXPECT_TRUE(reaches(view, stock_render(plain), Grade::exact));
  }
}

/// Behind each lens view 0 is the uppermost row; antialiased too. Files of all types are upright to viewers.
TEST_F(ImageAcrossSheets, FilesAreOnTheirSideAndSaySo) {
  const std::vector<std::string> common{"Lens_Pixels=6", "+W60", "+H48"};
  for (const char* name : {"sheet.png", "sheet.tif", "sheet.jpg", "sheet.exr"}) {
    std::vector<std::string> words = common;
    if (std::string(name).ends_with("jpg")) words.emplace_back("+FJ");
    render(name, words);
    const StoredImage stored = read(name), seen = upright(name);
    EXPECT_EQ(stored.width, 48u) << name;
    EXPECT_EQ(stored.height, 60u) << name;
    EXPECT_EQ(seen.width, 60u) << name;
    EXPECT_EQ(seen.height, 48u) << name;
    EXPECT_TRUE(tool::lies_across(tool::facts_of(seen))) << name;
  }
  const StoredImage sheet = upright("sheet.png");
  for (const std::uint32_t j : {0u, 3u, 5u}) {
    std::vector<std::string> words = common;
    words.push_back("View=" + std::to_string(j));
    render("view.png", words);
    EXPECT_TRUE(same_bits(read("view.png"), rows_of(sheet, j, 6))) << j;
    run("lentray-views", {"sheet.png", "--view", std::to_string(j), "--out", "taken.png"});
    EXPECT_TRUE(same_bits(read("taken.png"), read("view.png"))) << j;
  }
}

/// The size is that of the upright picture; pitch, N and the first resolution are downwards in it.
TEST_F(ImageAcrossSheets, SizesAreThoseOfTheUprightPicture) {
  render("sheet.png", {"Lens_LPI=40", "Print_DPI=240x120", "Sheet_Width=30mm", "Sheet_Height=20mm",
                       "View_Distance=inf"});
  const StoredImage sheet = upright("sheet.png");
  EXPECT_EQ(sheet.width, 142u);   // 30 mm at 120
  EXPECT_EQ(sheet.height, 189u);  // 20 mm at 240
  EXPECT_NEAR(number(sheet, "pixels"), 6.0, 1e-12);
  EXPECT_NEAR(number(sheet, "lenses"), 31.5, 1e-12);
  EXPECT_NEAR(number(sheet, "print_dpi_x"), 240.0, 1e-9);
  EXPECT_NEAR(number(sheet, "print_dpi_y"), 120.0, 1e-9);
  EXPECT_NEAR(tool::number_of(sheet.attributes, "YResolution"), 240.0, 0.02);
  const std::string said = run("lentray", {"+Ia.pov", "Lenticular=On", "Lens_Direction=across",
                                           "Lens_LPI=40", "Print_DPI=240x120", "Sheet_Width=30mm",
                                           "Sheet_Height=20mm", "View_Distance=40cm", "--explain"});
  EXPECT_NE(said.find("Lens sheet 29.9765 x 19.9491 mm"), std::string::npos) << said;
  EXPECT_NE(said.find("for a sheet of 30 x 20 mm"), std::string::npos) << said;
  EXPECT_NE(said.find("view 0 is seen from below"), std::string::npos) << said;
  EXPECT_EQ(said.find("left eye"), std::string::npos) << said;
}

TEST_F(ImageAcrossSheets, EyesAboveSeeTheLastViews) {
  render("sheet.png", {"Lens_Pixels=6", "+W60", "+H48", "View_Distance=inf"});
  run("lentray-views", {"sheet.png", "--all", "--out", "v#.png"});
  const StoredImage sheet = upright("sheet.png");
  // Where view 0 and the last one are seen, through the vertices of lenses by Snell's law.
  const double half = 2.5 / 6 * number(sheet, "pitch_mm"), f = number(sheet, "focal_length_mm");
  const double sine = number(sheet, "ior") * half / std::hypot(half, f);
  const std::string angle = std::to_string(std::asin(sine) * 180.0 / M_PI);
  run("lentray-views", {"sheet.png", "--eye", angle, "--out", "above.png"});
  run("lentray-views", {"sheet.png", "--eye=-" + angle, "--out", "below.png"});
  EXPECT_TRUE(same_bits(read("above.png"), read("v5.png")));
  EXPECT_TRUE(same_bits(read("below.png"), read("v0.png")));
  const std::string pair = run("lentray-views", {"sheet.png", "--stereo", "--out", "pair.png"});
  EXPECT_NE(pair.find("two eyes beside each other see the same view"), std::string::npos) << pair;
  EXPECT_EQ(read("pair.png").width, 120u);
  EXPECT_EQ(run("lentray-views", {"sheet.png", "--wiggle", "w.gif"}),
            "w.gif: 10 frames of 60 x 45 pixels\n");
  const std::string told = run("lentray-views", {"sheet.png"});
  EXPECT_NE(told.find("60 x 48 pixels, 8 lenses of 6 pixels, which lie across"), std::string::npos)
      << told;
  run("lentray-views", {"sheet.png", "--preview", "page.html"});
  EXPECT_NE(tool::read_text(m_folder / "page.html").find("\"is_across\":true"), std::string::npos);
  EXPECT_NE(run("lentray-views", {"sheet.png", "--quilt", "3x2"}, 1).find("lie across"),
            std::string::npos);
}

TEST_F(ImageAcrossSheets, ViewsArePutTogetherAgain) {
  render("sheet.png", {"Lens_Pixels=6", "+W60", "+H48"});
  run("lentray-views", {"sheet.png", "--all", "--out", "v#.png"});
  std::vector<std::string> words{"--interlace"};
  for (int j = 0; j < 6; ++j) words.push_back("v" + std::to_string(j) + ".png");
  std::vector<std::string> like = words;
  like.insert(like.end(), {"--like", "sheet.png", "--out", "again.png"});
  const std::string said = run("lentray-views", like);
  EXPECT_NE(said.find("again.png: 60 x 48 pixels"), std::string::npos) << said;
  EXPECT_NE(said.find("'v0.png', is seen from below, the last, 'v5.png', from above"),
            std::string::npos)
      << said;
  EXPECT_NE(said.find("lower edge turns away"), std::string::npos) << said;
  EXPECT_TRUE(same_bits(upright("again.png"), upright("sheet.png")));
  words.insert(words.end(),
               {"--lens-pixels", "6", "--size", "60x48", "--across", "--out", "b.png"});
  run("lentray-views", words);
  EXPECT_TRUE(same_bits(upright("b.png"), upright("sheet.png")));
  EXPECT_TRUE(tool::lies_across(tool::facts_of(read("b.png"))));
}

/// A flip of ready pictures is as large as it is asked for, and its page shows it upright.
TEST_F(ImageAcrossSheets, PagesShowItUpright) {
  run("lentray", {"+Ia.pov", "-V", "+W80", "+H60", "+Of0.png"});
  run("lentray-views",
      {"--interlace", "f0.png", "f0.png", "--across", "--lens-sheet", "40lpi", "--dpi", "240",
       "--size", "40x30mm", "--view-distance", "inf", "--out", "flip.png"});
  const StoredImage flip = upright("flip.png");
  EXPECT_EQ(flip.width, 378u);
  EXPECT_EQ(flip.height, 283u);
  const auto page_of = [&](std::vector<std::string> words) {
    words.insert(words.begin(), "sheet");
    words.insert(words.end(), {"--out", "page.png"});
    const std::string said = run("lentray-print", words);
    std::smatch at;
    EXPECT_TRUE(std::regex_search(said, at, std::regex("trimmed: .* at ([0-9.]+), ([0-9.]+) mm")))
        << said;
    const StoredImage page = read("page.png");
    const auto left = static_cast<std::uint32_t>(std::lround(std::stod(at[1]) / 25.4 * 240)),
               top = static_cast<std::uint32_t>(std::lround(std::stod(at[2]) / 25.4 * 240));
    std::size_t wrong = 0;
    // Whole lenses: 47 of 6 rows.
    for (std::uint32_t y = 0; y < 282; ++y) {
      for (std::uint32_t x = 0; x < flip.width; ++x)
        wrong += page.at(left + x, top + y, 0) != flip.at(x, y, 0);
    }
    EXPECT_EQ(wrong, 0u) << said;
    return said;
  };
  EXPECT_NE(page_of({"flip.png"}).find("left out below: 1 pixels"), std::string::npos);
  const StoredImage page = read("page.png");
  EXPECT_NE(page_of({"flip.png", "--horizontal"}).find("lie across already"), std::string::npos);
  EXPECT_TRUE(same_bits(read("page.png"), page));
  // TOP is above the picture: ink in the middle of the rows over its gratings.
  bool has_ink = false;
  for (std::uint32_t x = page.width / 2 - 20; x < page.width / 2 + 20; ++x)
    for (std::uint32_t y = 47; y < 65; ++y) has_ink |= page.at(x, y, 0) < 128.0f;
  EXPECT_TRUE(has_ink);
  // The picture of another program: upright as it is seen.
  core::write_stored(flip, m_folder / "plain.png");
  page_of({"plain.png", "--across", "--pixels", "6", "--dpi", "240"});
  const std::string mixed = run(
      "lentray-print",
      {"sheet", "flip.png", "plain.png", "--pixels", "6", "--dpi", "240", "--out", "none.png"}, 1);
  EXPECT_NE(mixed.find("a lens sheet has one direction"), std::string::npos) << mixed;
  run("lentray-print", {"pitch-test", "--lpi", "40", "--dpi", "240", "--across", "--out", "a.png"});
  run("lentray-print",
      {"pitch-test", "--lpi", "40", "--dpi", "240", "--horizontal", "--out", "b.png"});
  EXPECT_TRUE(same_bits(read("a.png"), read("b.png")));
}

/// Fitted to another pitch it is told how to render it anew: as the same sheet.
TEST_F(ImageAcrossSheets, TheExactCommandMakesSuchASheet) {
  render("sheet.png", {"Lens_LPI=40", "Print_DPI=240", "+W90", "+H60", "View_Distance=inf"});
  const std::string said =
      run("lentray-print", {"sheet", "sheet.png", "--pitch", "39.8lpi", "--out", "page.png"});
  std::smatch told;
  ASSERT_TRUE(std::regex_search(said, told, std::regex("exact: lentray SCENE.pov (.*)\n"))) << said;
  std::vector<std::string> words{"+Ia.pov", "-V", "+Oexact.png"};
  std::istringstream options(told[1]);
  for (std::string word; options >> word;) words.push_back(word);
  const auto result = run_lentray(words, m_folder.path());
  ASSERT_EQ(result.status, 0) << result.output;
  const StoredImage exact = upright("exact.png");
  EXPECT_EQ(exact.width, 90u);
  EXPECT_EQ(exact.height, 60u);
  EXPECT_TRUE(tool::lies_across(tool::facts_of(exact)));
  EXPECT_NEAR(number(exact, "print_pitch_mm"), 25.4 / 39.8, 1e-9);
}

/// By the formulae of lentray-diff, which know nothing of how the sheet lies; bands are joined with all that a file says.
TEST_F(ImageAcrossSheets, OtherProgramsKnowSuchSheets) {
  const std::vector<std::string> sheet{"Lenticular=On", "Lens_Direction=across", "Lens_Pixels=5",
                                       "+W80", "+H60"};
  for (const char* more : {"View_Distance=inf", "View=1"}) {
    std::vector<std::string> words{"a.pov", more};
    words.insert(words.end(), sheet.begin(), sheet.end());
    const auto result = run_diff(words, m_folder.path());
    EXPECT_EQ(result.status, 0) << result.output;
    EXPECT_NE(result.output.find("grade exact"), std::string::npos) << result.output;
  }
  render("whole.png", {"Lens_Pixels=5", "+W80", "+H60"});
  render("a.png", {"Lens_Pixels=5", "+W80", "+H60", "+ER30"});
  render("b.png", {"Lens_Pixels=5", "+W80", "+H60", "+SR31"});
  run("lentray-merge", {"a.png", "b.png", "--rows=1-30,31-80", "--out", "m.png"});
  EXPECT_EQ(tool::read_text(m_folder / "m.png"), tool::read_text(m_folder / "whole.png"));
}

TEST_F(ErrorAcrossSheets, WhatDoesNotGo) {
  const auto quilt = lentray({"Quilt=3x2", "Quilt_Tile=40x30"});
  EXPECT_EQ(quilt.status, 1);
  EXPECT_NE(quilt.output.find("Lens_Direction=across does not go with it"), std::string::npos)
      << quilt.output;
  const auto word = lentray({"Lens_Direction=down"});
  EXPECT_EQ(word.status, 1);
  EXPECT_NE(word.output.find("up"), std::string::npos) << word.output;
  const auto size = lentray({"Lens_LPI=40", "Print_DPI=240", "Sheet_Width=30mm",
                             "Sheet_Height=20mm", "View_Distance=inf", "+H99"});
  EXPECT_EQ(size.status, 1);
  EXPECT_NE(size.output.find("Height=99 and Sheet_Height=20mm at 240"), std::string::npos)
      << size.output;
}

}  // namespace
}  // namespace lentray::test
