// Views and quilts by the programs: lentray renders them, lentray-views takes integral images apart
// and puts them together. What a view is, is worked out here by a few lines of its own.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "tests/support/render.h"

namespace lentray::test {
namespace {

/// Depth on both sides of the sheet, which stands through the origin 5 before the eye.
constexpr const char* kViewsScene = R"(#version 3.7;
global_settings { assumed_gamma 1 }
#ifndef (Camera) #declare Camera = camera { location <0,0,-5> look_at 0 right x*4/3 } #end
camera { Camera }
light_source { <5,8,-6> rgb 1 }
background { rgb <0.2,0.3,0.5> }
plane { y, -1.2 pigment { checker rgb 0.9 rgb <0.4,0.5,0.2> } }
sphere { <0.6,0,1.5>, 0.9 pigment { rgb <1,0.6,0.1> } finish { phong 0.4 } }
sphere { <-0.9,-0.3,-0.8>, 0.5 pigment { rgb <0.2,0.5,1> } }
cylinder { <-1,-1,0>, <-1,1,0>, 0.2 pigment { rgb <1,0.2+clock*0.5,0.2> } }
)";

class ImageViews : public ::testing::Test {
 protected:
  void SetUp() override { tool::write_text(m_folder / "a.pov", kViewsScene); }

  tool::RunResult lentray(std::vector<std::string> words,
                          const std::string& scene = "a.pov") const {
    words.insert(words.begin(), {"+I" + scene, "-V"});
    return run_lentray(words, m_folder.path());
  }
  StoredImage render(const std::string& picture, std::vector<std::string> words,
                     const std::string& scene = "a.pov") const {
    words.push_back("+O" + picture);
    const auto result = lentray(words, scene);
    EXPECT_EQ(result.status, 0) << result.output;
    return core::read_image(m_folder / picture);
  }
  tool::RunResult views(std::vector<std::string> words) const {
    words.insert(words.begin(), program("lentray-views").string());
    return tool::run_program(words, m_folder.path(), 100);
  }
  void expect_done(const std::vector<std::string>& words) const {
    const auto result = views(words);
    EXPECT_EQ(result.status, 0) << result.output;
  }
  StoredImage read(const std::string& name) const { return core::read_image(m_folder / name); }
  bool is_there(const std::string& name) const { return std::filesystem::exists(m_folder / name); }
  static double number(const StoredImage& image, const std::string& name) {
    const auto found = image.attributes.find("lentray:" + name);
    EXPECT_NE(found, image.attributes.end()) << name;
    return found == image.attributes.end() ? 0.0 : std::strtod(found->second.c_str(), nullptr);
  }
  /// Columns of a picture by a list, one after another.
  static StoredImage columns_of(const StoredImage& image, const std::vector<std::uint32_t>& list) {
    StoredImage out = image;
    out.width = static_cast<std::uint32_t>(list.size());
    std::vector<float> samples;
    for (std::uint32_t row = 0; row < image.height; ++row) {
      for (const std::uint32_t column : list) {
        for (int c = 0; c < image.channels; ++c) samples.push_back(image.at(column, row, c));
      }
    }
    out.samples = core::Samples(samples);
    return out;
  }

  const tool::TemporaryFolder m_folder;
};
using ErrorViews = ImageViews;

/// The column of lens i whose offset is nearest to that of view j of m, by looking at all of them.
std::uint32_t nearest_by_hand(double n, std::uint32_t i, std::uint32_t j, std::uint32_t m) {
  std::uint32_t best = 0;
  double least = 1e9;
  for (auto k = static_cast<std::uint32_t>(i * n); k < (i + 1) * n + 1; ++k) {
    const double at = (k + 0.5) / n;
    if (std::floor(at) != i) continue;
    const double off = std::fabs(at - i - (j + 0.5) / m);
    if (off < least - 1e-9) {
      best = k;
      least = off;
    }
  }
  return best;
}

const std::vector<std::string> kWhole{"Lenticular=On", "Lens_Pixels=8", "+W480", "+H40", "+FN16"};

std::vector<std::string> views_with(std::vector<std::string> words,
                                    const std::vector<std::string>& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

TEST_F(ImageViews, StripsWhereLensesHaveNoWholePixels) {
  const std::vector<std::string> common{"Lenticular=On", "Lens_Pixels=7.37", "+W250", "+H20"};
  const StoredImage sheet = render("sheet.png", common);
  for (const std::uint32_t j : {0u, 3u, 6u}) {
    const std::string option = "View=" + std::to_string(j);
    const StoredImage view = render("view.png", views_with(common, {option}));
    std::vector<std::uint32_t> list;
    for (std::uint32_t i = 0; i < 34; ++i) {
      const std::uint32_t k = nearest_by_hand(7.37, i, j, 7);
      if (k < sheet.width) list.push_back(k);
    }
    EXPECT_TRUE(same_bits(view, columns_of(sheet, list))) << j;
    EXPECT_EQ(number(view, "lens.view"), j);
    EXPECT_EQ(number(view, "lens.view_count"), 7.0);
    EXPECT_FALSE(view.attributes.contains("XResolution"));
    ASSERT_EQ(views({"sheet.png", "--view", std::to_string(j), "--out", "taken.png"}).status, 0);
    EXPECT_TRUE(same_bits(read("taken.png"), view)) << j;
  }
  const auto beyond = lentray(views_with(common, {"View=7"}));
  EXPECT_EQ(beyond.status, 1);
  EXPECT_NE(beyond.output.find("there is no view 7: the views are 0 to 6"), std::string::npos)
      << beyond.output;
}

/// As many views as pixels in the size of one pixel a lens are the strips, bit for bit.
TEST_F(ImageViews, PicturesOfTheSheetsOwnViews) {
  const auto result = lentray(views_with(kWhole, {"Views=8", "View_Size=60x40", "+Oall.png"}));
  ASSERT_EQ(result.status, 0) << result.output;
  for (int j = 0; j < 8; ++j) {
    const std::string name = std::to_string(j);
    EXPECT_TRUE(same_bits(read("all" + name + ".png"),
                          render("one.png", views_with(kWhole, {"View=" + name}))))
        << j;
  }
  EXPECT_FALSE(is_there("all.png"));
  EXPECT_TRUE(
      same_bits(render("alone.png", views_with(kWhole, {"Views=8", "View=5", "View_Size=60x40"})),
                read("all5.png")));
}

/// Square pixels: the picture of an eye beside the camera's, its direction sheared, by stock too.
TEST_F(ImageViews, APictureOfAViewIsThatOfItsEye) {
  for (const int j : {0, 4}) {
    const StoredImage view = render("view.png", {"Lenticular=On", "Lens_Pixels=7.5", "Views=5",
                                                 "+W120", "+H90", "View=" + std::to_string(j)});
    ASSERT_EQ(view.width, 120u);
    // In the scene's units V is 5.
    const double eye = -5.0 * number(view, "lens.ior") * number(view, "lens.view_offset_mm") /
                       number(view, "lens.focal_length_mm");
    EXPECT_GT(std::fabs(eye), 0.3);
    char camera[200];
    std::snprintf(
        camera, sizeof camera,
        "#version 3.7; #declare Camera = camera { location <%.17g,0,-5> direction <%.17g,0,5> "
        "right x*20/3 up y*5 }\n",
        eye, -eye);
    const SceneText scene{.sdl = camera + std::string(kViewsScene),
                          .width = 120,
                          .height = 90,
                          .arguments = {},
                          .files = {}};
    EXPECT_TRUE(reaches(view, lentray_render(scene), Grade::exact)) << j;
    EXPECT_TRUE(reaches(view, stock_render(scene), Grade::exact)) << j;
  }
}

TEST_F(ImageViews, TheMiddleOneOfThreeIsTheOrdinaryPicture) {
  const StoredImage plain = render("plain.png", {"+W96", "+H72"});
  const StoredImage view =
      render("view.png", {"Lenticular=On", "Views=3", "View=1", "+W96", "+H72"});
  EXPECT_TRUE(reaches(view, plain, Grade::exact));
}

TEST_F(ImageViews, TheClockRunsOverTheViews) {
  ASSERT_EQ(
      lentray({"Lenticular=On", "Views=3", "View_Clock=0..1", "+W64", "+H48", "+Ov.png"}).status,
      0);
  EXPECT_TRUE(same_bits(read("v2.png"), render("late.png", {"Lenticular=On", "Views=3", "View=2",
                                                            "+K1", "+W64", "+H48"})));
  EXPECT_FALSE(same_bits(
      read("v2.png"), render("still.png", {"Lenticular=On", "Views=3", "View=2", "+W64", "+H48"})));
}

/// The scene says so each time it is read.
TEST_F(ImageViews, ViewsAreMadeOfOneReading) {
  const auto readings = [&](const std::vector<std::string>& words, const std::string& more) {
    tool::write_text(
        m_folder / "counts.pov",
        kViewsScene + more + "#fopen F \"readings\" append #write(F, \"x\") #fclose F\n");
    std::filesystem::remove(m_folder / "readings");
    EXPECT_EQ(lentray(views_with({"Lenticular=On", "+W32", "+H24", "+Ov.png"}, words), "counts.pov")
                  .status,
              0);
    return tool::read_text(m_folder / "readings");
  };
  EXPECT_EQ(readings({"Views=3"}, ""), "x");
  EXPECT_EQ(readings({"Views=3", "View_Clock=0..1"}, ""), "xxx")
      << "its cylinder asks for the clock";
  EXPECT_EQ(readings({"Views=3", "View_Clock=0..0"}, ""), "x") << "which is the same for all";
  EXPECT_EQ(readings({"+KFI1", "+KFF2"}, ""), "xx");
  // What each picture leaves besides.
  const auto result = lentray({"Lenticular=On", "Views=2", "+W32", "+H24", "+Ov.png",
                               "Statistics_File=s.json", "Dependencies_File=d.json"},
                              "counts.pov");
  EXPECT_EQ(result.status, 0) << result.output;
  for (const char* name : {"s0.json", "s1.json", "d0.json", "d1.json"})
    EXPECT_TRUE(is_there(name)) << name;
  EXPECT_EQ(tool::read_text(m_folder / "d0.json"), tool::read_text(m_folder / "d1.json"));
}

/// With all that depends on what was read: focal blur, slanted lenses, names of objects, going on.
TEST_F(ImageViews, ViewsOfOneReadingAreThoseOfTheirOwn) {
  tool::write_text(m_folder / "blur.pov",
                   std::string("#declare Camera = camera { location <0,0,-5> look_at 0 right x*4/3 "
                               "aperture 0.3 blur_samples 7 focal_point 0 }\n") +
                       kViewsScene);
  for (const auto& [slant, method] :
       {std::pair{"Lens_Slant=0", "+AM1"}, {"Lens_Slant=0", "+AM3"}, {"Lens_Slant=9", "+AM1"}}) {
    const std::vector<std::string> words{"Lenticular=On", "Lens_Pixels=8", slant,   "+W64", "+H40",
                                         "Views=4",       "+FN16",         "+A0.2", method};
    ASSERT_EQ(lentray(views_with(words, {"+Oall.png"}), "blur.pov").status, 0);
    for (const char* j : {"0", "1", "3"}) {
      EXPECT_TRUE(
          same_bits(read(std::string("all") + j + ".png"),
                    render("one.png", views_with(words, {std::string("View=") + j}), "blur.pov")))
          << slant << " " << j;
    }
  }
  // The first view is there already, and the others are of a reading without it.
  const std::vector<std::string> words{"Lenticular=On", "+W64", "+H40", "Views=3", "+C", "+Ov.png"};
  ASSERT_EQ(lentray(words).status, 0);
  const StoredImage last = read("v2.png");
  for (const char* name : {"v1.png", "v2.png"}) std::filesystem::remove(m_folder / name);
  ASSERT_EQ(lentray(words).status, 0);
  EXPECT_TRUE(same_bits(read("v2.png"), last));
}

TEST_F(ImageViews, ToViewsAndBackTheSheetIsTheSame) {
  const StoredImage sheet = render("sheet.png", kWhole);
  expect_done({"sheet.png", "--all", "--out", "v##.png"});
  std::vector<std::string> back{"--interlace", "--like", "sheet.png", "--out", "back.png"};
  for (std::uint32_t j = 0; j < 8; ++j) {
    const std::string name = "v0" + std::to_string(j) + ".png";
    std::vector<std::uint32_t> list;
    for (std::uint32_t i = 0; i < 60; ++i) list.push_back(i * 8 + j);
    EXPECT_TRUE(same_bits(read(name), columns_of(sheet, list))) << j;
    EXPECT_TRUE(same_bits(read(name),
                          render("one.png", views_with(kWhole, {"View=" + std::to_string(j)}))));
    EXPECT_EQ(number(read(name), "lens.view"), j);
    EXPECT_EQ(number(read(name), "lens.pitch_mm"), number(sheet, "lens.pitch_mm"));
    back.push_back(name);
  }
  expect_done(back);
  const StoredImage again = read("back.png");
  EXPECT_TRUE(same_bits(again, sheet));
  EXPECT_EQ(again.attributes, sheet.attributes);
  EXPECT_EQ(again.gamma, sheet.gamma);
}

/// Where N is not whole: the nearest pixels of the lenses, against the view's own rays.
TEST_F(ImageViews, NearestPixelsAreNearTheRenderedViews) {
  // The background moves by 1.7 pixels a view, and so by half of that at most from place to pixel.
  const std::vector<std::string> common{"Lenticular=On", "Lens_Pixels=14.3", "Lens_Focal_Length=12",
                                        "+W2860", "+H150"};
  render("sheet.png", common);
  double worst = 1e9;
  for (const char* j : {"0", "5", "13"}) {
    const StoredImage rendered =
        render("view.png",
               views_with(common, {"Views=14", std::string("View=") + j, "View_Size=200x150"}));
    expect_done({"sheet.png", "--view", j, "--out", "taken.png"});
    const StoredImage taken = read("taken.png");
    ASSERT_EQ(taken.width, 200u);
    worst = std::min(worst, core::compare(taken, rendered, core::Columns::all(200)).psnr);
  }
  std::printf("nearest pixels against rendered views: %.1f dB at worst\n", worst);
  EXPECT_GE(worst, 30.0);
}

TEST_F(ImageViews, AQuiltOfASheetIsTheSameByBothWays) {
  render("sheet.png", kWhole);
  const StoredImage quilt =
      render("scene.png", views_with(kWhole, {"Quilt=4x2", "Views=8", "Quilt_Tile=60x40"}));
  ASSERT_EQ(quilt.width, 240u);
  ASSERT_EQ(quilt.height, 80u);
  expect_done({"sheet.png", "--quilt", "4x2", "--out", "taken.png"});
  EXPECT_TRUE(same_bits(read("taken.png"), quilt));
  for (const char* name : {"quilt.columns", "quilt.rows", "lens.pitch_mm"})
    EXPECT_EQ(number(read("taken.png"), name), number(quilt, name));
  EXPECT_NEAR(number(read("taken.png"), "quilt.aspect"), number(quilt, "quilt.aspect"), 1e-5);
  EXPECT_FALSE(quilt.attributes.contains("XResolution"));
  EXPECT_FALSE(read("taken.png").attributes.contains("XResolution"));
  // Of ready pictures, which are the rightmost camera's first.
  expect_done({"sheet.png", "--all", "--out", "v#.png"});
  std::vector<std::string> words{"--quilt", "4x2", "--out", "joined.png"};
  for (int j = 0; j < 8; ++j) words.push_back("v" + std::to_string(j) + ".png");
  expect_done(words);
  EXPECT_TRUE(same_bits(read("joined.png"), quilt));
  // The leftmost camera's view is the last of the sheet.
  std::vector<std::uint32_t> first(60), last(60);
  for (std::uint32_t i = 0; i < 60; ++i) first[i] = i;
  const StoredImage strip = columns_of(quilt, first), view = read("v7.png");
  for (std::uint32_t row = 0; row < 40; ++row) {
    for (std::uint32_t i = 0; i < 60; ++i) ASSERT_EQ(strip.at(i, row + 40, 1), view.at(i, row, 1));
  }
}

TEST_F(ImageViews, QuiltsForDisplaysAreNamedByThem) {
  render("sheet.png", kWhole);
  const auto result = views({"sheet.png", "--quilt", "4x2", "--aspect", "0.75"});
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.output, "sheet_qs4x2a0.75.png: 240 x 80 pixels\n");
  EXPECT_TRUE(is_there("sheet_qs4x2a0.75.png"));
}

/// The outermost cameras of a cone, on a line, sheared towards the sheet; the picture as wide as
/// the display.
TEST_F(ImageViews, AQuiltHasTheCamerasOfItsCone) {
  const auto told =
      lentray({"Quilt=3x2", "Quilt_Tile=90x120", "Quilt_Aspect=0.75", "View_Cone=40", "+Oq.png"});
  ASSERT_EQ(told.status, 0) << told.output;
  EXPECT_NE(told.output.find("to end in _qs3x2a0.75"), std::string::npos) << told.output;
  EXPECT_NE(told.output.find("Its cameras look over 40 degrees: 3.6397 scene units"),
            std::string::npos)
      << told.output;
  const StoredImage quilt = read("q.png");
  ASSERT_EQ(quilt.width, 270u);
  ASSERT_EQ(quilt.height, 240u);
  EXPECT_EQ(number(quilt, "quilt.view_cone_degrees"), 40.0);
  EXPECT_FALSE(quilt.attributes.contains("XResolution"));
  const double reach = 5.0 * std::tan(20.0 * std::acos(-1.0) / 180.0);
  for (const std::uint32_t tile : {0u, 1u, 5u}) {
    const double eye = reach * (tile / 2.5 - 1.0);
    char camera[200];
    std::snprintf(
        camera, sizeof camera,
        "#version 3.7; #declare Camera = camera { location <%.17g,0,-5> direction <%.17g,0,5> "
        "right x*3.75 up y*5 }\n",
        eye, -eye);
    const SceneText scene{.sdl = camera + std::string(kViewsScene),
                          .width = 90,
                          .height = 120,
                          .arguments = {},
                          .files = {}};
    StoredImage part = stock_render(scene);
    std::vector<float> samples;
    const std::uint32_t left = tile % 3 * 90, top = tile < 3 ? 120 : 0;
    for (std::uint32_t row = 0; row < 120; ++row) {
      for (std::uint32_t column = 0; column < 90; ++column) {
        for (int c = 0; c < 3; ++c) samples.push_back(quilt.at(left + column, top + row, c));
      }
    }
    StoredImage ours = part;
    ours.samples = core::Samples(samples);
    EXPECT_TRUE(reaches(ours, part, Grade::exact)) << tile;
  }
}

/// Antialiasing joins the columns of a tile with no other tile's.
TEST_F(ImageViews, AntialiasedQuilts) {
  const std::vector<std::string> more{"+A0.1", "-J", "+FN8"};
  const StoredImage quilt = render(
      "q.png", views_with(views_with(kWhole, more), {"Quilt=4x2", "Views=8", "Quilt_Tile=60x40"}));
  for (const std::uint32_t j : {2u, 7u}) {
    const StoredImage view =
        render("v.png", views_with(views_with(kWhole, more), {"View=" + std::to_string(j)}));
    const std::uint32_t tile = 7 - j, left = tile % 4 * 60, top = tile < 4 ? 40 : 0;
    for (std::uint32_t row = 1; row < 40; ++row) {
      for (std::uint32_t i = 0; i < 60; ++i) {
        for (int c = 0; c < 3; ++c)
          ASSERT_EQ(quilt.at(left + i, top + row, c), view.at(i, row, c)) << j << " " << row;
      }
    }
  }
}

TEST_F(ImageViews, WhatAnEyeSees) {
  const StoredImage sheet = render("sheet.png", kWhole);
  // The eye of view 6, as docs/lens.md has it.
  const double pitch = number(sheet, "lens.print_pitch_mm"), e = (6.5 / 8 - 0.5) * pitch;
  const double slope = number(sheet, "lens.ior") * e / number(sheet, "lens.focal_length_mm");
  char eye[64];
  std::snprintf(eye, sizeof eye, "--eye=%.15g,%.15g", -std::atan(slope) * 180.0 / std::acos(-1.0),
                number(sheet, "lens.view_distance_mm"));
  expect_done({"sheet.png", eye, "--out", "eye.png"});
  expect_done({"sheet.png", "--view", "6", "--out", "v6.png"});
  EXPECT_TRUE(same_bits(read("eye.png"), read("v6.png")));
  EXPECT_GT(number(read("eye.png"), "eye.distance_mm"), 1.0);
  // Without a distance it is the sheet's own.
  expect_done({"sheet.png", "--eye", "0", "--between", "--square", "--out", "ahead.png"});
  EXPECT_NEAR(read("ahead.png").width, 40 * 4.0 / 3.0, 1.0);
}

TEST_F(ImageViews, PairsAndMovingPictures) {
  render("sheet.png", kWhole);
  expect_done({"sheet.png", "--stereo", "--eyes", "10", "--out", "pair.png"});
  EXPECT_EQ(read("pair.png").width, 120u);
  expect_done({"sheet.png", "--stereo", "--pair", "6,1", "--out", "pair.png"});
  expect_done({"sheet.png", "--all", "--out", "v#.png"});
  std::vector<std::uint32_t> left(60), right(60);
  for (std::uint32_t i = 0; i < 60; ++i) {
    left[i] = i;
    right[i] = 60 + i;
  }
  EXPECT_TRUE(same_bits(columns_of(read("pair.png"), left), read("v6.png")));
  EXPECT_TRUE(same_bits(columns_of(read("pair.png"), right), read("v1.png")));
  expect_done({"v6.png", "v1.png", "--stereo", "--out", "two.png"});
  EXPECT_TRUE(same_bits(read("two.png"), read("pair.png")));
  expect_done({"sheet.png", "--anaglyph=plain", "--pair", "6,1", "--out", "red.png"});
  EXPECT_EQ(read("red.png").at(30, 20, 0), read("v6.png").at(30, 20, 0));
  EXPECT_EQ(read("red.png").at(30, 20, 2), read("v1.png").at(30, 20, 2));
  const auto moving = views({"sheet.png", "--wiggle", "w.gif", "--square"});
  EXPECT_EQ(moving.output, "w.gif: 14 frames of 53 x 40 pixels\n");
  EXPECT_EQ(read("w.gif").width, 53u);
  expect_done({"sheet.png", "--wiggle", "w.png", "--views", "2..4"});
  EXPECT_EQ(read("w.png").width, 60u);  // square pixels, none of the sheet's lost
  EXPECT_EQ(read("w.png").height, 45u);
}

TEST_F(ImageViews, PhotographsBecomeASheet) {
  render("left.png", {"+W80", "+H60"});
  render("right.png", {"+W80", "+H60", "+K1"});
  expect_done({"--interlace", "left.png", "right.png", "--lens-pixels", "6", "--size", "240x60",
               "--from-left", "--out", "flip.png"});
  const StoredImage flip = read("flip.png");
  EXPECT_EQ(flip.width, 240u);
  EXPECT_EQ(number(flip, "lens.pixels"), 6.0);
  // The first named is the leftmost camera's, the last view.
  expect_done(
      {"flip.png", "--view", "5", "--size", "80x60", "--filter", "mitchell", "--out", "back.png"});
  EXPECT_GT(core::compare(read("back.png"), read("left.png"), core::Columns::all(80)).psnr, 20.0);
  const auto told = views({"flip.png"});
  EXPECT_NE(told.output.find("flip.png: 240 x 60 pixels, 40 lenses of 6 pixels"), std::string::npos)
      << told.output;
  EXPECT_NE(told.output.find("Nothing is known of --lens-pitch"), std::string::npos);
}

/// Box is left out, which has ties where pictures grow.
TEST_F(ImageViews, FiltersAreThoseOfOpenImageIO) {
  render("a.exr", {"+W60", "+H90", "+FE32"});
  for (const char* filter : {"triangle", "mitchell", "lanczos3"}) {
    for (const char* size : {"25x77", "97x211"}) {
      expect_done({"a.exr", "--lens-pixels", "1", "--view", "0", "--size", size, "--filter", filter,
                   "--out", "ours.exr"});
      const auto theirs = tool::run_program(
          {"oiiotool", "a.exr", std::string("--resize:filter=") + filter, size, "-o", "theirs.exr"},
          m_folder.path(), 100);
      ASSERT_EQ(theirs.status, 0) << theirs.output;
      const StoredImage a = read("ours.exr"), b = read("theirs.exr");
      ASSERT_EQ(a.samples.size(), b.samples.size());
      for (std::size_t i = 0; i < a.samples.size(); ++i)
        ASSERT_NEAR(a.samples[i], b.samples[i], 1e-4) << filter << " " << size;
    }
  }
}

TEST_F(ErrorViews, EveryMessage) {
  render("sheet.png", kWhole);
  render("plain.png", {"+W80", "+H60"});
  render("small.png", {"+W40", "+H30"});
  expect_done({"sheet.png", "--view", "3", "--out", "v3.png"});
  expect_done({"sheet.png", "--quilt", "4x2", "--out", "q.png"});
  const std::pair<std::vector<std::string>, const char*> rows[] = {
      {{}, "no picture is given"},
      {{"none.png"}, "cannot read 'none.png': there is no such file"},
      {{"plain.png", "--all"},
       "'plain.png' does not say how many pixels a lens has: --lens-pixels"},
      {{"plain.png", "--eye", "3", "--lens-pixels", "8"},
       "'plain.png' does not say all of its lenses: give --lens-pitch, --lens-focal-length, "
       "--lens-ior, --view-distance"},
      {{"plain.png", "--lens-pixels", "81"}, "which is less than a lens of 81"},
      {{"plain.png", "--lens-pixels", "8", "--all", "--square"},
       "'plain.png' does not say how large its sheet is: give --aspect"},
      {{"v3.png", "--all"}, "'v3.png' is view 3 of a sheet, and no integral image"},
      {{"q.png", "--all"}, "'q.png' is a quilt, and no integral image"},
      {{"sheet.png", "--view", "8"}, "there is no view 8: the views are 0 to 7"},
      {{"sheet.png", "--views", "5..8"}, "there is no view 8: the views are 0 to 7"},
      {{"sheet.png", "--views", "5..4"}, "a first and a last view are expected, such as 0..14"},
      {{"sheet.png", "--lens", "60"}, "there is no lens 60: the lenses are 0 to 59"},
      {{"sheet.png", "--quilt", "8"}, "columns x rows of views are expected, such as 8x6"},
      {{"sheet.png", "--quilt", "4x2", "--count", "7"}, "contradict each other"},
      {{"v3.png", "v3.png", "--quilt", "4x2"}, "wants as many pictures, not 2"},
      {{"v3.png", "plain.png", "--quilt", "2x1"}, "these views do not go together: they have"},
      {{"v3.png", "v3.png", "v3.png", "--stereo"}, "--pair L,R gives"},
      {{"v3.png", "v3.png", "--stereo", "--square"}, "--square is of integral images"},
      {{"sheet.png", "--eye", "90"}, "an angle between -90 and 90 degrees is expected"},
      {{"sheet.png", "--eye", "5,0"}, "the eye's distance must be greater than 0 mm"},
      {{"sheet.png", "--all", "--lens", "3"}, "--all and --lens are two tasks"},
      {{"sheet.png", "--view", "3", "--views", "3..4"}, "--views and --view contradict"},
      {{"sheet.png", "--lens", "3", "--views", "3..4"}, "--views does not go with --lens"},
      {{"sheet.png", "--all", "--eye", "3"}, "--eye does not go with --all"},
      {{"sheet.png", "--all", "--pair", "1,2"}, "--pair is of --stereo and --anaglyph"},
      {{"sheet.png", "--stereo", "--pair", "1"}, "the left and the right eye's view are expected"},
      {{"sheet.png", "--stereo", "--pair", "1,2", "--eye", "3"}, "--pair and --eye contradict"},
      {{"sheet.png", "--all", "--square", "--size", "8x8"}, "--square and --size contradict"},
      {{"sheet.png", "--all", "--size", "8"}, "a size such as 420x560 is expected"},
      {{"sheet.png", "--all", "--filter", "cubic"}, "there are box, triangle, mitchell, lanczos3"},
      {{"sheet.png", "--lens-model", "flat"}, "there are paraxial, pinhole and thick"},
      {{"sheet.png", "--view-distance", "-1"}, "a distance of 0 or more is expected"},
      {{"sheet.png", "--lens-pixels", "0.5"}, "at least one pixel a lens is expected"},
      {{"sheet.png", "--anaglyph=green"}, "there are --anaglyph=dubois and --anaglyph=plain"},
      {{"sheet.png", "--wiggle", "w.mp4"}, "moving pictures are .gif and .png files"},
      {{"sheet.png", "--wiggle", "w.gif", "--views", "3..9"}, "there is no view 9"},
      {{"sheet.png", "--wiggle", "w.gif", "--delay", "1"}, "--delay 1"},
      {{"sheet.png", "--view", "3", "--out", "sheet.png"}, "this run reads that file"},
      {{"sheet.png", "--view", "3", "--out", "a.bmp"}, "there are .png, .tif, .exr and .jpg"},
      {{"sheet.png", "--view", "3", "--out", "none/a.png"}, "cannot write 'none/a.png'"},
      {{"sheet.png", "plain.png", "--all"}, "'plain.png': one integral image is expected"},
      {{"sheet.png", "--like", "sheet.png"}, "--like is of --interlace"},
      {{"--interlace", "v3.png", "--lens-pixels", "8"}, "wants two pictures or more"},
      {{"--interlace", "v3.png", "v3.png"}, "wants --like IMAGE, or --lens-pixels N"},
      {{"--interlace", "v3.png", "v3.png", "--like", "sheet.png", "--size", "8x8"},
       "--size and --like contradict each other"},
      {{"--interlace", "v3.png", "v3.png", "--like", "sheet.png", "--square"},
       "--square is of views"},
      {{"--interlace", "plain.png", "small.png", "--lens-pixels", "8"},
       "'plain.png' and 'small.png' are not views of one sheet: they have 80 x 60 and 40 x 30"},
      {{"--interlace", "plain.png", "plain.png", "--lens-pixels", "1"}, "has no room for 2 views"},
      {{"--interlace", "plain.png", "plain.png", "--lens-pixels", "90000"}, "too wide: --size WxH"},
      {{"sheet.png", "--wriggle"}, "unknown option '--wriggle'"},
      {{"sheet.png", "--out"}, "--out needs a value"},
      {{"sheet.png", "--out="}, "the name of a file is expected"}};
  for (const auto& [words, part] : rows) {
    const auto result = views(words);
    EXPECT_EQ(result.status, 1) << part;
    EXPECT_TRUE(result.output.starts_with("lentray-views: ")) << result.output;
    EXPECT_NE(result.output.find(part), std::string::npos)
        << "got: " << result.output << "wanted: " << part;
  }
  for (const char* name : {"w.gif", "a.bmp", "plain_sheet.png"})
    EXPECT_FALSE(is_there(name)) << name;
}

TEST_F(ErrorViews, OptionsOfLentray) {
  const auto expect = [&](const std::vector<std::string>& words, const std::string& part) {
    const auto result = lentray(words);
    EXPECT_EQ(result.status, 1);
    EXPECT_NE(result.output.find(part), std::string::npos) << result.output;
  };
  expect({"Views=3"}, "Views=3 needs a lens sheet: add Lenticular=On");
  expect({"Quilt=1x1"}, "a quilt has at least two views");
  expect({"Lenticular=On", "Views=3", "View=3"}, "there is no view 3: the views are 0 to 2");
  const auto told = lentray({"Quilt=2x1", "+W40", "+H15", "Lens_Pixels=9", "+Oq.png"});
  EXPECT_EQ(told.status, 0);
  EXPECT_NE(told.output.find("the lens options have no effect on a quilt"), std::string::npos)
      << told.output;
}

TEST_F(ImageViews, HelpAndVersion) {
  const auto help = views({"--help"});
  EXPECT_EQ(help.status, 0);
  EXPECT_TRUE(help.output.starts_with("usage: lentray-views "));
  EXPECT_TRUE(views({"--version"}).output.starts_with("lentray-views "));
}

}  // namespace
}  // namespace lentray::test
