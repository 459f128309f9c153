// Pictures that their kind of file cannot hold are refused before they are rendered, by name and limit, and leave nothing.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "tests/support/render.h"

namespace lentray::test {
namespace {

namespace fs = std::filesystem;

struct TooLarge {
  std::string name;
  std::vector<std::string> arguments;
  std::string file, limit;
};

class ImageSizeLimits : public ::testing::TestWithParam<TooLarge> {};

TEST_P(ImageSizeLimits, IsRefusedBeforeRendering) {
  const TooLarge& given = GetParam();
  const tool::TemporaryFolder folder;
  tool::write_text(folder / "scene.pov",
                   "#version 3.7; global_settings { assumed_gamma 1 }\n"
                   "camera { location -5*z look_at 0 } sphere { 0, 1 pigment { rgb 1 } }\n");
  std::vector<std::string> arguments = given.arguments;
  arguments.insert(arguments.begin(), {"+Iscene.pov", "+Oa"});
  const tool::RunResult run = run_lentray(arguments, folder.path());
  EXPECT_EQ(run.status, 1) << run.output;
  EXPECT_NE(run.output.find("cannot write '" + given.file + "'"), std::string::npos) << run.output;
  EXPECT_NE(run.output.find(given.limit), std::string::npos) << run.output;
  EXPECT_EQ(run.output.find("Rendering"), std::string::npos) << run.output;
  for (const auto& entry : fs::directory_iterator(folder.path()))
    EXPECT_EQ(entry.path().filename(), "scene.pov");
}

const std::vector<std::string> kSheet = {"Lenticular=On", "Lens_LPI=40", "View_Distance=400"};
TooLarge of_sheet(std::string name, std::vector<std::string> more, std::string file) {
  std::vector<std::string> all = kSheet;
  all.insert(all.end(), more.begin(), more.end());
  return {std::move(name), all, std::move(file), "65500 pixels a side"};
}

const std::vector<TooLarge> kTooLarge = {
    {"JpegWide", {"+W65501", "+H1", "+FJ"}, "a.jpg", "65500 pixels a side"},
    {"JpegHigh", {"+W1", "+H65501", "+FJ"}, "a.jpg", "65500 pixels a side"},
    {"JpegFrames", {"+W66000", "+H1", "+FJ", "+KFF12"}, "a01.jpg", "65500 pixels a side"},
    {"TargaWide", {"+W65536", "+H1", "+FT"}, "a.tga", "65535 pixels a side"},
    {"TargaInRunsHigh", {"+W1", "+H65536", "+FC"}, "a.tga", "65535 pixels a side"},
    {"Bmp", {"+W65536", "+H21846", "+FB"}, "a.bmp", "less than 4 GB"},
    {"BmpWithAlpha", {"+W32768", "+H32768", "+FB", "+UA"}, "a.bmp", "less than 4 GB"},
    of_sheet("JpegSheet", {"+W66000", "+H1", "Lens_Pixels=10", "+FJ"}, "a.jpg"),
    of_sheet("JpegViews", {"Lens_Pixels=10", "Views=2", "View_Size=66000x2", "+FJ"}, "a0.jpg"),
    of_sheet("JpegQuilt", {"Quilt=3x2", "View_Size=22000x2", "View_Cone=30", "+FJ"}, "a.jpg")};

INSTANTIATE_TEST_SUITE_P(Kinds, ImageSizeLimits, ::testing::ValuesIn(kTooLarge),
                         [](const auto& one) { return one.param.name; });

/// The largest that there are, of these and of others that have no limit.
TEST(ImageSizes, WhatFits) {
  for (const char* type :
       {"+FJ", "+FT", "+FC", "+FN", "+FP", "+FE", "+FH", "+FB", "Output_File_Type=TIFF"}) {
    const std::string most = std::string(type) == "+FJ"                                 ? "65500"
                             : std::string(type) == "+FT" || std::string(type) == "+FC" ? "65535"
                                                                                        : "70000";
    for (const std::vector<std::string>& size :
         {std::vector<std::string>{"+W" + most, "+H1"}, {"+W1", "+H" + most}}) {
      const tool::TemporaryFolder folder;
      tool::write_text(folder / "scene.pov",
                       "#version 3.7; global_settings { assumed_gamma 1 } background { rgb .5 }\n");
      const tool::RunResult run =
          run_lentray({"+Iscene.pov", "+Oa", "-V", type, size[0], size[1]}, folder.path());
      ASSERT_EQ(run.status, 0) << type << run.output;
      std::size_t pictures = 0;
      for (const auto& entry : fs::directory_iterator(folder.path())) {
        if (entry.path().stem() != "a") continue;
        ++pictures;
        const core::StoredImage image = core::read_image(entry.path());
        EXPECT_EQ(image.width * image.height, std::stoul(most)) << type;
      }
      EXPECT_EQ(pictures, 1u) << type;
    }
  }
}

}  // namespace
}  // namespace lentray::test
