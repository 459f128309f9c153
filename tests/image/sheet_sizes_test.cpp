// From a scene to a print: lens sheets whose size is given in mm, what the files say of it, and that
// no bad number does more than make a message.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/image/reader.h"
#include "tests/support/render.h"
#include "tools/common/process.h"

namespace lentray::test {
namespace {

namespace fs = std::filesystem;

constexpr const char* kSheetSizesScene = R"(#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0,2,-6> look_at <0,0.75,0> right x*image_width/image_height }
#debug concat("size ", str(image_width,0,0), " x ", str(image_height,0,0), "\n")
light_source { <-5,8,-6>, 1 }
sphere { <0,1,0>, 1 pigment { rgb <.9,.3,.2> } }
plane { y, 0 pigment { checker rgb 1 rgb .5 } }
)";

class ImageSheetSizes : public ::testing::Test {
 protected:
  void SetUp() override { tool::write_text(path("scene.pov"), kSheetSizesScene); }
  tool::RunResult lentray(const std::vector<std::string>& arguments) {
    return run_lentray(arguments, m_folder.path());
  }
  /// With an asked size of 100 x 70 mm at 40 lenses an inch.
  tool::RunResult sheet(std::vector<std::string> more) {
    more.insert(more.begin(), {"scene.pov", "Lenticular=On", "Lens_LPI=40", "Sheet_Width=100mm",
                               "Sheet_Height=70mm"});
    return lentray(more);
  }
  fs::path path(const std::string& name) const { return m_folder / name; }

 private:
  tool::TemporaryFolder m_folder;
};
using ErrorSheetSizes = ImageSheetSizes;

bool sheet_sizes_has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// The job of somebody with a scene, a sheet, a printer and a place to look from: one command, and no
/// number is computed by hand. The expected sizes are.
TEST_F(ImageSheetSizes, AScenesPrintInOneCommand) {
  const std::string scene = "/usr/share/doc/povray/examples/advanced/woodbox.pov";
  ASSERT_TRUE(fs::exists(scene)) << "the package povray-examples is needed";
  // From 400 mm the print of a sheet 0.9 mm thick, of index 1.5, is 1 + 0.9/600 times as large:
  // 100.15 x 70.105 mm, which at 127 pixels an inch, 0.2 mm each, are 500.75 x 350.525 pixels.
  for (const char* name : {"print.tif", "print.png"}) {
    const auto result =
        lentray({scene, "Lenticular=On", "Lens_LPI=40", "Lens_Thickness=0.9mm", "Lens_IOR=1.5",
                 "Sheet_Width=100mm", "Sheet_Height=7cm", "Print_DPI=127", "View_Distance=400mm",
                 std::string("+O") + name, "Statistics_File=s.json"});
    ASSERT_EQ(result.status, 0) << result.output;
    EXPECT_FALSE(sheet_sizes_has(result.output, "warning: the camera's picture")) << result.output;
    const StoredImage image = core::read_image(path(name));
    EXPECT_EQ(image.width, 501u);
    EXPECT_EQ(image.height, 351u);
    // What a printer's program makes of the file.
    const double dpi_x = std::stod(image.attributes.at("XResolution")),
                 dpi_y = std::stod(image.attributes.at("YResolution"));
    EXPECT_NEAR(image.width * 25.4 / dpi_x, 100.2, 0.01) << name;
    EXPECT_NEAR(image.height * 25.4 / dpi_y, 70.2, 0.01) << name;
    const auto lens = nlohmann::json::parse(tool::read_text(path("s.json")))["lens"];
    EXPECT_NEAR(lens["print_width_mm"], 100.2, 1e-9);
    EXPECT_NEAR(lens["print_height_mm"], 70.2, 1e-9);
    EXPECT_NEAR(lens["sheet_width_mm"], 100.2 / 1.0015, 1e-9);
    EXPECT_NEAR(lens["sheet_height_mm"], 70.2 / 1.0015, 1e-9);
    EXPECT_NEAR(lens["pixels"], 0.635 * 1.0015 / 0.2, 1e-12);
    EXPECT_EQ(lens["model"], "paraxial");
    for (const char* part :
         {"Lens sheet 100.05 x 70.0949 mm", "Print 100.2 x 70.2 mm", "127 x 127 ppi",
          "Rounded to whole pixels, 501 x 351, for a sheet of 100 x 70 mm: 0.04993 mm wider, "
          "0.09486 mm higher; the last lens is cut",
          "Viewing angle 59.96 degrees; at 400 mm the zone to view it from is ",
          "The left eye sees place "}) {
      EXPECT_TRUE(sheet_sizes_has(result.output, part)) << part << "\n" << result.output;
    }
    EXPECT_FALSE(sheet_sizes_has(result.output, "For a print say also")) << result.output;
  }
}

/// image_width and image_height are those of the sheet, so that scenes take its shape.
TEST_F(ImageSheetSizes, ScenesLearnThePicturesSize) {
  const auto result = sheet({"Print_DPI=127", "--explain"});
  EXPECT_EQ(result.status, 0);
  EXPECT_TRUE(sheet_sizes_has(result.output, "size 501 x 351\n")) << result.output;
  EXPECT_FALSE(sheet_sizes_has(result.output, "too wide"));
  tool::write_text(path("narrow.pov"), "#version 3.7;\ncamera { location -6*z right x }\n");
  EXPECT_TRUE(sheet_sizes_has(lentray({"narrow.pov", "Lenticular=On", "Sheet_Distance=6",
                                       "Sheet_Width=100", "Sheet_Height=50", "--explain"})
                                  .output,
                              "things look 100 % too wide"));
}

TEST_F(ImageSheetSizes, AnotherResolutionDownwards) {
  ASSERT_EQ(sheet({"Print_DPI=254x127", "-V", "+Ox.png", "View_Distance=inf"}).status, 0);
  const StoredImage image = core::read_image(path("x.png"));
  EXPECT_EQ(image.width, 1000u);
  EXPECT_EQ(image.height, 350u);
  EXPECT_NEAR(std::stod(image.attributes.at("XResolution")), 254.0, 0.01);
  EXPECT_NEAR(std::stod(image.attributes.at("YResolution")), 127.0, 0.01);
}

TEST_F(ImageSheetSizes, SheetsAreListedWithoutAScene) {
  tool::write_text(path("lens_sheets.ini"), "[mine]\nLens_LPI=60.02\n");
  for (const char* option : {"--lens-sheets", "Lens_Sheet=list"}) {
    const auto result = lentray({option});
    EXPECT_EQ(result.status, 0);
    EXPECT_TRUE(sheet_sizes_has(result.output, "mine")) << result.output;
    EXPECT_TRUE(sheet_sizes_has(result.output, "75lpi-0.457mm")) << result.output;
  }
  const auto mine = lentray({"scene.pov", "Lenticular=On", "Lens_Sheet=mine", "--explain"});
  EXPECT_TRUE(sheet_sizes_has(mine.output, "60.02 lpi")) << mine.output;
  tool::write_text(path("lens_sheets.ini"), "[mine]\nLens_LPI=many\n");
  const auto bad = lentray({"--lens-sheets"});
  EXPECT_EQ(bad.status, 1);
  EXPECT_TRUE(sheet_sizes_has(bad.output, "lens_sheets.ini:2: option Lens_LPI=many")) << bad.output;
}

TEST_F(ErrorSheetSizes, ASizeWithoutASheet) {
  const auto result = lentray(
      {"scene.pov", "Sheet_Width=10mm", "Sheet_Height=10mm", "Print_DPI=127", "-V", "+Ox.png"});
  EXPECT_EQ(result.status, 0);
  EXPECT_TRUE(sheet_sizes_has(result.output,
                              "the picture has the columns and rows of the lens sheet, but without "
                              "Lenticular=On it is none"))
      << result.output;
  EXPECT_EQ(core::read_image(path("x.png")).width, 50u);
}

TEST_F(ErrorSheetSizes, AScenesOwnLens) {
  tool::write_text(path("own.pov"),
                   "#version 3.7;\ncamera { lenticular location 0 right 4*x up 3*y lens_pitch 1 "
                   "lens_pixels 10 }\n");
  const auto result =
      lentray({"own.pov", "Sheet_Width=40", "Sheet_Height=30", "Lens_Pixels=10", "+Ox.png"});
  EXPECT_EQ(result.status, 1);
  EXPECT_TRUE(sheet_sizes_has(result.output, "the scene's own lens makes the sheet 35.6 mm wide"))
      << result.output;
  EXPECT_FALSE(fs::exists(path("x.png")));
  EXPECT_EQ(lentray({"own.pov", "Sheet_Width=40", "Sheet_Height=30", "Lens_Pitch=1",
                     "Lens_Pixels=10", "-V"})
                .status,
            0);
}

/// Numbers beyond all reason, through the whole program: a message or a picture, and no nan.
TEST_F(ErrorSheetSizes, BadNumbersEndInMessages) {
  const std::vector<std::pair<std::vector<std::string>, std::string>> runs{
      {{"Lens_Thickness=1e300"}, "the lens thickness must be 1e-6 to 1e6 mm"},
      {{"Lens_Thickness=1e-300"}, "the lens thickness must be 1e-6 to 1e6 mm"},
      {{"Lens_Radius=1e300"}, "the lens radius must be 1e-6 to 1e6 mm"},
      {{"Lens_Radius=0.1"}, "such lenses are 0.2 mm wide at most"},
      {{"Lens_Radius=1", "Lens_IOR=1"}, "needs a refractive index greater than 1"},
      {{"Lens_IOR=1e300"}, "must be 100 at most"},
      {{"Lens_Angle=1e-300"}, "the lens thickness must be 1e-6 to 1e6 mm"},
      {{"Lens_Angle=179.9", "Lens_IOR=1", "Lens_Pixels=2"}, ""},
      {{"Lens_Angle=90", "Lens_Thickness=20"}, "need a refractive index of 44."},
      {{"Lens_Thickness=0.3", "Lens_IOR=2", "Lens_Model=pinhole"},
       "show nothing"},  // total reflection
      {{"Lens_Thickness=0.3", "Lens_IOR=2", "View_Distance=400"}, "Viewing angle 180 degrees\n"},
      {{"Lens_Thickness=0.3", "Lens_IOR=2", "Lens_Model=thick"}, "there is no such lens"},
      {{"View_Distance=1e300"}, "the viewing distance must be 1e-6 to 1e12 mm"},
      {{"View_Distance=1e-300"}, "the viewing distance must be 1e-6 to 1e12 mm"},
      {{"View_Distance=1um"}, "Viewing angle 180 degrees\n"},
      {{"View_Distance=1e9m"}, "there is little depth or none"},
      {{"Lens_Tolerance=1e300", "Lens_Model=auto"}, "Lens model paraxial, the cheapest"},
      {{"Lens_Tolerance=1e-300", "Lens_Model=auto"}, "Lens model pinhole, the cheapest"}};
  for (const auto& [arguments, text] : runs) {
    std::vector<std::string> all{"scene.pov", "Lenticular=On", "Lens_LPI=40",
                                 "+W60",      "+H20",          "--explain"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    const auto result = lentray(all);
    EXPECT_LE(result.status, 1) << result.output;
    EXPECT_TRUE(sheet_sizes_has(result.output, text)) << arguments[0] << "\n" << result.output;
    for (const char* bad : {"nan", " inf ", "-inf", "inf.", "inf mm", "inf degrees"}) {
      EXPECT_FALSE(sheet_sizes_has(result.output, bad)) << arguments[0] << "\n" << result.output;
    }
  }
  const auto large = sheet({"Print_DPI=3e7", "Sheet_Width=1.5m", "+Ox.png"});
  EXPECT_EQ(large.status, 1);
  EXPECT_TRUE(sheet_sizes_has(large.output, "of memory for a row")) << large.output;
  EXPECT_FALSE(fs::exists(path("x.png")));
}

}  // namespace
}  // namespace lentray::test
