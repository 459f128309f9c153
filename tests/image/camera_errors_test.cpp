// Every error of a camera or a lens sheet says where it comes from: the camera statement with line and column, or the
// options, as they were said, with their lines of INI files.
#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>

#include "tests/support/render.h"

namespace lentray::test {
namespace {

struct CameraErrorCase {
  std::string camera;  ///< the third line of the scene
  std::vector<std::string> options;
  std::string message;              ///< a part of it
  bool has_place = true;            ///< of the statement
  std::vector<std::string> said{};  ///< those options that the message names
};
void PrintTo(const CameraErrorCase& c, std::ostream* out) { *out << c.camera << ": " << c.message; }

const std::string kPlain = "camera { location -6*z look_at 0 }";
const std::string kBlurred = "camera { location -6*z look_at 0 blur_samples 4 ";
const std::string kSheet = "camera { lenticular location -6*z look_at 0 ";

const CameraErrorCase kOfStatement[] = {
    {"camera { location -5*z right 0 look_at 0 }", {"Lenticular=On"}, "vectors of some length"},
    {"camera { location -5*z right <1,1,0> up y }", {"Lenticular=On"}, "not perpendicular to `up`"},
    {"camera { location -5*z right x direction x }",
     {"Lenticular=On"},
     "lies in the picture plane"},
    {"camera { location -5*z direction -z }", {"Lenticular=On"}, "has no look_at and sees nothing"},
    {"camera { location <0,0,-1e40> look_at 0 }", {"Lenticular=On"}, "too far away"},
    {kBlurred + "aperture 1e200 focal_point 0 }", {}, "the aperture is too large"},
    {kBlurred + "aperture 1 focal_point 1e200*z }", {}, "what is in focus lies"},
    {"camera { mesh_camera { 1, 0 mesh { triangle { 0, x, 2*x } } } }", {}, "have no faces"},
    {kBlurred + "aperture 1 bokeh { pigment { image_map { png \"none.png\" } } } }",
     {},
     "'none.png'"},
    {"camera { location -6*z normal { bump_map { png \"none.png\" } } }", {}, "'none.png'"},
    {kSheet + "lens_pitch 1 lens_lpi 75 }", {}, "75 lenses an inch"},
    {kSheet + "lens_pixels 10 print_dpi 720 }", {}, "720 pixels an inch"},
    {kSheet + "lens_model thick lens_pitch 3 lens_focal_length 1 }", {}, "there is no such lens"},
    {kSheet + "lens_pitch 1e-9 }", {}, "the lens pitch must be"},
    {kSheet + "lens_ior 400 }", {}, "refractive index of the lens must be 100"},
    {"camera { lenticular location -6*z right x+y up y direction z }", {}, "not perpendicular to"},
    {kSheet + "aperture 1 blur_samples 4 focal_point 0 lens_model thick lens_pitch .5 }",
     {},
     "no focal blur"},
};

const CameraErrorCase kOfBoth[] = {
    {"camera { fisheye location -5*z }",
     {"Lenticular=On"},
     "`fisheye` camera",
     true,
     {"Lenticular=On"}},
    {"camera { spherical }", {"Lenticular=On"}, "`spherical` camera", true, {"Lenticular=On"}},
    {"camera { mesh_camera { 1, 0 mesh { triangle { 0, x, y } } } }",
     {"Quilt=2x2", "Quilt_Tile=9x9"},
     "`mesh_camera`",
     true,
     {"Quilt=2x2"}},
    {kPlain,
     {"Lenticular=On", "Sheet_Distance=1e35"},
     "too far away",
     true,
     {"Sheet_Distance=1e35"}},
    {kPlain,
     {"Lenticular=On", "Depth=viewer", "Print_DPI=1e6"},
     "no sheet at",
     true,
     {"Print_DPI=1e6"}},
    {kPlain,
     {"Lenticular=On", "Depth_Budget=1e-9"},
     "depth would be nothing",
     true,
     {"Depth_Budget=1e-9"}},
    {kBlurred + "aperture 1 focal_point 0 }",
     {"Lenticular=On", "Lens_Model=thick"},
     "no focal blur",
     true,
     {"Lens_Model=thick"}},
    {kSheet + "lens_pitch 1 }", {"Lens_Radius=0.1"}, "such lenses are", true, {"Lens_Radius=0.1"}},
    {kSheet + "lens_pixels 10 }", {"View=77"}, "there is no view 77", true, {"View=77"}},
};

const CameraErrorCase kOfOptions[] = {
    {kPlain,
     {"Lenticular=On", "Sheet_Distance=0"},
     "must be greater than 0",
     false,
     {"Sheet_Distance=0"}},
    {kPlain, {"Lenticular=On", "Lens_Radius=0.1"}, "such lenses are", false, {"Lens_Radius=0.1"}},
    {kPlain,
     {"Lenticular=On", "Lens_Pitch=1", "Lens_LPI=75"},
     "contradict each other",
     false,
     {"Lens_Pitch=1", "Lens_LPI=75"}},
    {kPlain,
     {"Lenticular=On", "Lens_Radius=1", "Lens_IOR=1"},
     "index greater than 1",
     false,
     {"Lens_Radius=1", "Lens_IOR=1"}},
    {kPlain,
     {"Lenticular=On", "Lens_Focal_Length=1", "Lens_Radius=3"},
     "contradict",
     false,
     {"Lens_Focal_Length=1", "Lens_Radius=3"}},
    {kPlain,
     {"Lenticular=On", "Lens_Radius=0.3", "Lens_Thickness=0.05", "Lens_Pitch=0.59"},
     "mm high",
     false,
     {"Lens_Radius=0.3", "Lens_Thickness=0.05", "Lens_Pitch=0.59"}},
    {kPlain,
     {"Lenticular=On", "Lens_Angle=120", "Lens_Thickness=9", "Lens_Pitch=0.1"},
     "refractive index of",
     false,
     {"Lens_Angle=120", "Lens_Thickness=9", "Lens_Pitch=0.1"}},
    {kPlain,
     {"Lenticular=On", "Print_DPI=1"},
     "give it one, and six are few",
     false,
     {"Print_DPI=1"}},
    {kPlain, {"Lenticular=On", "Print_LPI=60"}, "needs a View_Distance", false, {"Print_LPI=60"}},
    {kPlain,
     {"Lenticular=On", "Print_LPI=60", "Lens_LPI=60", "View_Distance=400"},
     "give one of them",
     false,
     {"Print_LPI=60", "Lens_LPI=60"}},
    {kPlain, {"Lenticular=On", "View=99"}, "there is no view 99", false, {"View=99"}},
    {kPlain, {"View=1"}, "needs a lens sheet", false, {"View=1"}},
    {kPlain, {"Views=3", "View_Size=20x20"}, "needs a lens sheet", false, {"Views=3"}},
    {kPlain, {"Quilt=1x1", "Quilt_Tile=20x20"}, "at least two views", false, {"Quilt=1x1"}},
    {kPlain,
     {"Quilt=2x2", "Quilt_Tile=20x20", "Depth_Budget=1mm"},
     "Depth_Budget in mm",
     false,
     {"Depth_Budget=1mm", "Quilt=2x2"}},
    {kPlain,
     {"Quilt=2x2", "Quilt_Tile=20x20", "View=1"},
     "View= does not go with it",
     false,
     {"View=1", "Quilt=2x2"}},
    {kPlain, {"View_Cone=30"}, "there is no Quilt=", false, {"View_Cone=30"}},
    {kPlain,
     {"Lenticular=On", "Lens_Model=thick", "Lens_Pitch=3", "Lens_Focal_Length=1"},
     "there is no such lens",
     false,
     {"Lens_Pitch=3", "Lens_Focal_Length=1", "Lens_Model=thick"}},
    {kPlain,
     {"Lenticular=On", "Sheet_Width=40mm"},
     "needs Sheet_Height",
     false,
     {"Sheet_Width=40mm"}},
    {kPlain,
     {"Lenticular=On", "Sheet_Width=1e9mm", "Sheet_Height=20mm"},
     "1e6 mm wide",
     false,
     {"Sheet_Width=1e9mm"}},
    {kPlain,
     {"Lenticular=On", "Sheet_Width=40mm", "Sheet_Height=20mm", "Print_DPI=1e12"},
     "1e9 pixels",
     false,
     {"Print_DPI=1e12"}},
    {kPlain,
     {"Lenticular=On", "Sheet_Width=40mm", "Sheet_Height=20mm", "Lens_Pixels=10", "Width=60"},
     "contradict",
     false,
     {"Sheet_Width=40mm", "Lens_Pixels=10", "Width=60"}},
    {kPlain,
     {"Lenticular=On", "Print_DPI=720x1440"},
     "a second number of Print_DPI",
     false,
     {"Print_DPI=720x1440"}},
    {kPlain,
     {"Lenticular=On", "Lens_Sheet=none-such"},
     "there is no lens sheet",
     false,
     {"Lens_Sheet=none-such"}},
};

class ErrorCameraPlaces : public ::testing::TestWithParam<CameraErrorCase> {
 protected:
  void SetUp() override {
    tool::write_text(m_folder / "s.pov",
                     "#version 3.7; global_settings { assumed_gamma 1 }\n"
                     "sphere { 0, 1 pigment { rgb 1 } }\n" +
                         GetParam().camera + "\n");
  }
  std::string render(std::vector<std::string> words) {
    words.insert(words.begin(), {"+Is.pov", "-F", "-V", "+H30"});
    const tool::RunResult run = run_lentray(words, m_folder.path());
    EXPECT_EQ(run.status, 1) << run.output;
    EXPECT_NE(run.output.find(GetParam().message), std::string::npos) << run.output;
    const bool has_place = run.output.find("s.pov:3:") != std::string::npos &&
                           run.output.find(": error: ") != std::string::npos &&
                           run.output.find("   ^") != std::string::npos;
    EXPECT_EQ(has_place, GetParam().has_place) << run.output;
    return run.output;
  }
  tool::TemporaryFolder m_folder;
};

TEST_P(ErrorCameraPlaces, NameTheStatementAndTheOptions) {
  const std::string said = render(GetParam().options);
  for (const std::string& option : GetParam().said)
    EXPECT_NE(said.find(option), std::string::npos) << said;
}

TEST_P(ErrorCameraPlaces, NameTheLinesOfIniFiles) {
  if (GetParam().options.empty()) return;
  std::string lines = "; a lens sheet\n";
  for (const std::string& option : GetParam().options) lines += option + "\n";
  tool::write_text(m_folder / "o.ini", lines);
  const std::string text = render({"o.ini"});
  for (std::size_t i = 0; i < GetParam().options.size(); ++i) {
    const std::string& option = GetParam().options[i];
    if (std::ranges::find(GetParam().said, option) == GetParam().said.end()) continue;
    const std::string whole = option + " in o.ini:" + std::to_string(i + 2);
    EXPECT_NE(text.find(whole), std::string::npos) << whole << " is missing in: " << text;
  }
}

INSTANTIATE_TEST_SUITE_P(Statement, ErrorCameraPlaces, ::testing::ValuesIn(kOfStatement));
INSTANTIATE_TEST_SUITE_P(Both, ErrorCameraPlaces, ::testing::ValuesIn(kOfBoth));
INSTANTIATE_TEST_SUITE_P(Options, ErrorCameraPlaces, ::testing::ValuesIn(kOfOptions));

}  // namespace
}  // namespace lentray::test
