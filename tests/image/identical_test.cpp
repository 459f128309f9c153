// The picture is the same, bit for bit, whatever the pixel order, shadow cache, accelerator and
// threads.
#include <gtest/gtest.h>

#include "tests/support/render.h"

namespace lentray::test {
namespace {

namespace fs = std::filesystem;

/// Counted within the suite.
std::size_t number_of_test() {
  const ::testing::UnitTest& all = *::testing::UnitTest::GetInstance();
  const ::testing::TestSuite& suite = *all.current_test_suite();
  int number = 0;
  while (suite.GetTestInfo(number) != all.current_test_info()) ++number;
  return static_cast<std::size_t>(number);
}

struct PictureSize {
  const char *width, *height;
};

/// The parameter: one of how many pairs of an order and a cache are tried. 1: all.
class ImageIdentical : public ::testing::TestWithParam<std::size_t> {
 protected:
  void expect_identical(const std::vector<std::string>& scene);
  /// The same in a smaller picture where few pairs are tried.
  void expect_identical(std::vector<std::string> scene, const PictureSize& all,
                        const PictureSize& few);

 private:
  std::size_t m_scene = number_of_test();
};
/// Which pairs these are differs from scene to scene, so that together the tests try all.
INSTANTIATE_TEST_SUITE_P(Some, ImageIdentical, ::testing::Values(8));
INSTANTIATE_TEST_SUITE_P(Slow, ImageIdentical, ::testing::Values(1));

/// Renders the scene in these ways and holds each picture against the first.
void ImageIdentical::expect_identical(const std::vector<std::string>& scene) {
  const tool::TemporaryFolder folder;
  StoredImage first;
  // Bands as high as the picture, a row, odd, and more than a row of tiles.
  const std::vector<std::string> bands{"", "Band_Height=1", "Band_Height=7", "Band_Height=40"};
  constexpr int kThreads[] = {1, 2, 5};
  const std::vector<std::vector<std::string>> accelerators{
      {}, {"Accelerator=grid"}, {"-UL", "Specialised_Paths=Off"}, {"Accelerator=list"}};
  const std::size_t number = m_scene++;
  std::size_t run = number, pair = 0;
  // Every order with every cache; bands, threads and accelerators change from run to run and from scene to scene,
  // so that each meets every order and every cache.
  for (const char* order : {"rows", "views", "columns", "combined(4)", "strips(3,7)", "tiles",
                            "serpentine", "hilbert", "adaptive", "auto"}) {
    for (const char* cache :
         {"off", "last", "depth", "tree", "neighbourhood", "grid", "cascade", "auto"}) {
      const std::size_t row = pair / 8, column = pair % 8;
      ++pair;
      if ((row + column + number) % GetParam() != 0) continue;
      const int threads = kThreads[(run + run / 7) % std::size(kThreads)];
      std::vector<std::string> arguments = scene;
      const std::vector<std::string> way{
          std::string("Pixel_Order=") + order, std::string("Shadow_Cache=") + cache,
          "+WT" + std::to_string(threads), bands[(run + run / 14) % bands.size()]};
      const std::vector<std::string>& search =
          accelerators[(run + run / 7 + run / 28) % accelerators.size()];
      ++run;
      arguments.insert(arguments.end(), way.begin(), way.end());
      arguments.insert(arguments.end(), search.begin(), search.end());
      arguments.insert(arguments.end(), {"+Oa.png", "+FN16", "-V"});
      const tool::RunResult result = run_lentray(arguments, folder.path());
      ASSERT_EQ(result.status, 0) << result.output;
      const StoredImage picture = core::read_image(folder / "a.png");
      if (first.samples.empty()) first = picture;
      ASSERT_TRUE(same_bits(first, picture))
          << way[0] << " " << way[1] << " " << way[2] << " " << way[3] << " "
          << (search.empty() ? "" : search.front());
    }
  }
}

void ImageIdentical::expect_identical(std::vector<std::string> scene, const PictureSize& all,
                                      const PictureSize& few) {
  const PictureSize& size = GetParam() == 1 ? all : few;
  scene.insert(scene.end(), {size.width, size.height});
  expect_identical(scene);
}

std::string identical_scene_file(const char* name) {
  return "+I" + (source_folder() / "scenes" / name).string();
}

TEST_P(ImageIdentical, BallsIntegral) {
  expect_identical(
      {identical_scene_file("spd_balls.pov"), "Declare=Size=3", "Declare=Lenticular_Camera=1"},
      {"+W150", "+H100"}, {"+W75", "+H50"});
}

TEST_P(ImageIdentical, GearsIntegral) {
  expect_identical(
      {identical_scene_file("spd_gears.pov"), "Declare=Size=2", "Declare=Lenticular_Camera=1"},
      {"+W90", "+H60"}, {"+W60", "+H42"});
}

TEST_P(ImageIdentical, DemoIntegral) {
  expect_identical({identical_scene_file("demo.pov"), "Lenticular=On", "+W120", "+H90"});
}

TEST_P(ImageIdentical, FractionalLensesIntegral) {
  expect_identical(
      {identical_scene_file("demo.pov"), "Lenticular=On", "Lens_Pixels=12.5", "+W120", "+H90"});
}

TEST_P(ImageIdentical, ThickLensesIntegral) {
  expect_identical({identical_scene_file("demo.pov"), "Lenticular=On", "Lens_Model=thick",
                    "Lens_Rays=3", "Lens_Pixels=6", "+W60", "+H40"});
  // Some rays show nothing; antialiased.
  expect_identical({identical_scene_file("demo.pov"), "Lenticular=On", "Lens_Model=thick",
                    "Lens_Rays=4", "Lens_Pitch=2.2", "Lens_Focal_Length=3.03", "Lens_Pixels=6",
                    "Antialias_Angle=2", "+A0.2", "+R2", "+W48", "+H24"});
}

TEST_P(ImageIdentical, SlantedLensesIntegral) {
  expect_identical({identical_scene_file("demo.pov"), "Lenticular=On", "Lens_Slant=1/3",
                    "Lens_Pixels=7.37", "+W100", "+H60"});
  expect_identical({identical_scene_file("demo.pov"), "Lenticular=On", "Lens_Slant=-20",
                    "Lens_Model=thick", "Lens_Rays=2", "Lens_Pixels=6", "View_Distance=inf",
                    "Antialias_Angle=2", "+A0.2", "+R2", "+W48", "+H30"});
  expect_identical({identical_scene_file("demo.pov"), "Lenticular=On", "Lens_Slant=1/6", "+AM2",
                    "+A0.1", "+R2", "Lens_Pixels=6", "+W48", "+H30"});
  expect_identical({identical_scene_file("demo.pov"), "Lenticular=On", "Lens_Slant=1/6", "+AM3",
                    "+A0.1", "Lens_Pixels=6", "+W48", "+H30"});
}

TEST_P(ImageIdentical, DemoInItsOwnCamera) {
  expect_identical({identical_scene_file("demo.pov"), "+W120", "+H90"});
}

const char* const kBlurred = R"(#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0.3,2,-6> look_at <0,0.7,0> angle 40 aperture 0.8 focal_point 0 blur_samples 5,12 }
light_source { <3,9,-4> rgb 0.7 }
light_source { <-5,6,-3> rgb 0.5 area_light x*2, z*2, 4, 4 adaptive 1 jitter }
plane { y, 0 pigment { checker rgb 0.9, rgb <0.6,0.7,0.9> } finish { reflection 0.15 } }
sphere { <-1,0.8,0>, 0.8 pigment { rgb <0.9,0.5,0.3> } finish { phong 0.6 crand 0.1 } }
sphere { <0.7,0.6,-1.4>, 0.6 pigment { rgb <0.6,1,0.8> filter 0.8 } interior { ior 1.3 } }
box { <1.2,0,1>, <2.2,1.3,2> pigment { rgb <0.5,0.8,0.4> } }
)";

TEST_P(ImageIdentical, FocalBlur) {
  const tool::TemporaryFolder folder;
  tool::write_text(folder / "blurred.pov", kBlurred);
  const std::string scene = "+I" + (folder / "blurred.pov").string();
  expect_identical({scene, "+W40", "+H30"});
  expect_identical({scene, "Lenticular=On", "Lens_Pixels=6", "Antialias_Angle=2", "+W36", "+H20"});
}

const char* const kTranslucent = R"(#version 3.7;
global_settings { assumed_gamma 1 mm_per_unit 20 subsurface { samples 8, 3 radiosity on }
  radiosity { count 8 error_bound 1 recursion_limit 1 subsurface on } }
camera { location <0.3,2,-6> look_at <0,0.7,0> angle 40 }
light_source { <3,9,-4> rgb 0.7 }
light_source { <-5,6,-3> rgb 0.5 area_light x*2, z*2, 4, 4 adaptive 1 jitter }
plane { y, 0 pigment { rgb 0.7 } finish { reflection 0.2 } }
sphere { <-1,0.8,0>, 0.8 pigment { agate } finish { subsurface { translucency <9,5,2> } }
  interior { ior 1.3 } }
sphere { <0.7,0.6,-1.4>, 0.6 pigment { rgb <0.6,1,0.8> filter 0.5 } finish { subsurface {
  translucency 20 } } interior { ior 1.3 } }
)";

TEST_P(ImageIdentical, SubsurfaceLight) {
  const tool::TemporaryFolder folder;
  tool::write_text(folder / "translucent.pov", kTranslucent);
  expect_identical({"+I" + (folder / "translucent.pov").string(), "+W24", "+H18"});
}

const char* const kShot = R"(#version 3.7;
global_settings { assumed_gamma 1 photons { spacing 0.1 media 8 } }
camera { location <0,2.5,-4.5> look_at <0,0.4,0> angle 45 }
light_source { <1.5,5,-1> rgb 1 photons { reflection on refraction on } }
plane { y, 0 pigment { rgb <0.9,0.85,0.8> } }
sphere { <0,1.2,0>, 0.5 pigment { rgbf <1,0.9,0.8,0.95> } finish { reflection 0.1 }
  interior { ior 1.5 } photons { target reflection on refraction on } }
box { <-0.8,0.01,-1>, <0.8,0.6,1> hollow pigment { rgbt 1 } photons { pass_through }
  interior { media { scattering { 1, 0.5 } samples 3 density { bozo scale 0.3 } } } }
)";

TEST_P(ImageIdentical, Photons) {
  const tool::TemporaryFolder folder;
  tool::write_text(folder / "shot.pov", kShot);
  expect_identical({"+I" + (folder / "shot.pov").string(), "+W24", "+H18"});
}

/// A sheet without thickness tilted so that it rises from 3e-4 to 4e-3 above a plane, under the light: across the
/// distance below which blockers are not seen. A cache that tests what it remembers otherwise
/// than the full search does lets the order of pixels show here; stock's does.
std::string plate_scene(double height) {
  return R"(#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0,4,-4> look_at 0 }
light_source { <0.3,9,-0.2> rgb 1 }
light_source { <-4,9,3> rgb 0.5 }
plane { y, 0 pigment { rgb 1 } finish { reflection 0.2 } }
polygon { 5, <-1,-1>, <1,-1>, <1,1>, <-1,1>, <-1,-1> pigment { rgb 0.5 } no_image no_reflection
  rotate 90*x rotate 0.106*z translate ()" +
         std::to_string(height) + R"( + 0.00215)*y }
sphere { <0.4,0.8,0>, 0.3 pigment { rgb <1,0,0> } finish { reflection 0.5 } }
)";
}

TEST_P(ImageIdentical, PlateJustAboveAFloor) {
  const tool::TemporaryFolder folder;
  tool::write_text(folder / "plate.pov", plate_scene(0.0));
  expect_identical({"+I" + (folder / "plate.pov").string(), "+W80", "+H60"});
  expect_identical({"+I" + (folder / "plate.pov").string(), "Lenticular=On", "+W90", "+H60"});
  // The near end lets light through: without that the scene would prove nothing.
  const StoredImage low = lentray_render({.sdl = plate_scene(0.0), .arguments = {}, .files = {}});
  const StoredImage high = lentray_render({.sdl = plate_scene(0.01), .arguments = {}, .files = {}});
  EXPECT_GT(core::compare(low, high, core::Columns::all(low.width)).beyond_2, 30u);
}

/// Everything that may stand in the way of light: opaque, clear and filtering objects, textures
/// that are clear in places, CSG, unions, light groups, no_shadow, walls of 1e-5 to 1e-2 above what
/// they shade, and lights of all kinds.
const char* const kOccluders = R"(#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 5 }
camera { location <0.3,4,-7> look_at <0,0.7,0> angle 50 }
light_source { <3,9,-4> rgb 0.5 }
light_source { <-6,7,-2> rgb 0.4 parallel point_at 0 }
light_source { <-2,8,-6> rgb 0.6 spotlight point_at 0 radius 20 falloff 30 }
light_source { <5,6,3> rgb <0.5,0.4,0.3> area_light x*1.5, z*1.5, 4, 4 adaptive 1 }
light_source { <0,6,6> rgb 0.2 area_light x, y, 3, 3 circular orient }
plane { y, 0 pigment { checker rgb 0.9, rgb <0.6,0.7,0.9> } finish { reflection 0.15 } }
sphere { <-2,0.8,0>, 0.8 pigment { rgb <0.9,0.5,0.3> } finish { phong 0.6 reflection 0.2 } }
sphere { <-0.3,0.6,-1.4>, 0.6 pigment { rgb <0.6,1,0.8> filter 0.8 } interior { ior 1.3 } }
box { <1.2,0,-1>, <2.2,1.3,0> pigment { bozo scale 0.3
  color_map { [0.4 rgb 0.8] [0.5 rgb <1,1,0.5> transmit 0.9] } } rotate 10*y }
sphere { <0,2.2,0.6>, 0.5 pigment { rgb <1,0.2,0.2> } no_shadow }
difference { box { <-0.8,0,0.6>, <0.8,1.4,2> } sphere { <0,1.2,1.2>, 0.7 } cylinder { 3*z, -z, 0.3 }
  pigment { rgb <0.4,0.6,0.9> } }
intersection { sphere { <2.4,1,1.4>, 0.8 } sphere { <2.9,1.2,1.2>, 0.8 }
  pigment { rgb <0.8,0.8,0.3> } }
merge { sphere { <-1.4,0.4,-2>, 0.4 } sphere { <-1,0.4,-2>, 0.4 } pigment { rgbt <0.9,0.9,1,0.5> } }
union {
  sphere { <-3,0.4,1.6>, 0.4 } torus { 0.7, 0.12 rotate 20*x translate <-3,0.9,1.6> }
  union { cone { <-3,1,1.6>, 0.3, <-3,1.8,1.6>, 0 } box { <-3.6,0,2.2>, <-2.4,0.9,2.3> } }
  pigment { rgb <0.7,0.4,0.8> }
}
blob { threshold 0.5 sphere { <3.2,0.5,-1.6>, 0.8, 1 } sphere { <3.8,0.6,-1.4>, 0.7, 1 }
  pigment { rgb 0.7 } }
mesh {
  triangle { <-4,0,0>, <-3.2,1.6,0>, <-3.2,0,-0.6> }
  triangle { <-3.2,0,-0.6>, <-3.2,1.6,0>, <-2.9,0,0.3> }
  pigment { rgb <0.3,0.8,0.4> }
}
light_group {
  light_source { <4,5,-6> rgb 0.4 }
  light_source { <-4,6,-3> rgb 0.3 area_light x, z, 3, 3 adaptive 1 }
  cylinder { <-2.6,0,-2.2>, <-2.6,1.1,-2.2>, 0.25 pigment { rgb <0.9,0.6,0.5> } }
  box { <0.2,0,-2.4>, <0.7,0.5,-2> pigment { rgbf <0.7,0.8,1,0.6> } }
  global_lights on
}
#for (I, 0, 6)
  // a plate each for 1e-5, 3.2e-5 ... 1e-2 above the floor, and above a slanted wall
  #declare Gap = pow(10, -5 + I/2);
  box { <-1.6 + 0.5*I, Gap, -3>, <-1.25 + 0.5*I, Gap + 0.02, -2.7> pigment { rgb 0.5 } no_image }
  polygon { 5, <0,0>, <0.3,0>, <0.3,0.3>, <0,0.3>, <0,0>
    pigment { rgb <1,0.9,0.2> #if (mod(I, 2)) transmit 0.5 #end } no_image no_reflection
    rotate 90*x translate <-1.6 + 0.5*I, Gap, -3.6> }
#end
)";

/// Media in the air and in solids, by all methods, in the way of light too; and lights and glass that
/// send many rays.
const char* const kHaze = R"(#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 }
camera { location <0.3,2,-7> look_at <0,0.7,0> angle 45 }
light_source { <3,9,-4> rgb 0.6 media_attenuation on }
light_source { <-4,7,-3> rgb 0.8 spotlight point_at 0 radius 10 falloff 18 }
light_source { <5,6,3> rgb 0.4 area_light x*2, z*2, 3, 3 jitter area_illumination }
light_source { <-6,8,2> rgb 0.5 projected_through { disc { <-3,4,1>, <-1,1,0.3>, 0.8 } } }
plane { y, 0 hollow pigment { checker rgb 0.9, rgb <0.6,0.7,0.9> } finish { reflection 0.1 } }
sphere { <-1.6,0.9,0>, 0.9 hollow pigment { rgbt 1 } interior { media {
  method 1 intervals 3 samples 1, 4 emission 0.2 absorption <0.2,0.5,0.8>
  density { bozo scale 0.4 color_map { [0.3 rgb 0] [0.6 rgb 2] } } } } }
sphere { <0.4,0.7,-0.6>, 0.7 pigment { rgbf <0.9,1,0.9,0.8> } finish { reflection 0.1 }
  interior { ior 1.4 dispersion 1.1 dispersion_samples 5 } }
box { <1.2,0,0>, <2.2,1.4,1> hollow pigment { rgbt 0.9 } interior { media {
  method 2 samples 4 jitter 0.5 scattering { 5, 0.5 eccentricity 0.3 } } } }
media { scattering { 4, 0.01 } samples 3 jitter 0.3 }
)";

TEST_P(ImageIdentical, Media) {
  const tool::TemporaryFolder folder;
  tool::write_text(folder / "haze.pov", kHaze);
  const std::string scene = "+I" + (folder / "haze.pov").string();
  expect_identical({scene, "+W40", "+H30"});
  expect_identical({scene, "Lenticular=On", "Lens_Pixels=6", "+W48", "+H24"});
}

/// Several tiles, whose edges cut lenses' neighbours.
TEST_P(ImageIdentical, AntialiasedInTiles) {
  expect_identical({identical_scene_file("demo.pov"), "+A0.2", "+R2"}, {"+W140", "+H130"},
                   {"+W80", "+H72"});
}

TEST_P(ImageIdentical, AntialiasedByCorners) {
  expect_identical({identical_scene_file("demo.pov"), "+A0.1", "+AM2", "+R2"}, {"+W120", "+H90"},
                   {"+W72", "+H48"});
}

TEST_P(ImageIdentical, AntialiasedSheetInTiles) {
  expect_identical(
      {identical_scene_file("demo.pov"), "Lenticular=On", "Lens_Pixels=1.2", "+A0.2", "+R2"},
      {"+W160", "+H130"}, {"+W80", "+H72"});
}

TEST_P(ImageIdentical, AntialiasedSheetByCorners) {
  expect_identical({identical_scene_file("demo.pov"), "Lenticular=On", "Lens_Pixels=7.37",
                    "Antialias_Angle=2", "+A0.2", "+AM2", "+R2"},
                   {"+W72", "+H48"}, {"+W48", "+H36"});
}

TEST_P(ImageIdentical, AntialiasedSheetForTheEye) {
  expect_identical({identical_scene_file("demo.pov"), "Lenticular=On", "Lens_Pixels=7.37", "+A0.2",
                    "+AM3", "+R2"},
                   {"+W100", "+H60"}, {"+W64", "+H40"});
}

class ImageIdenticalOccluders : public ImageIdentical {
 protected:
  void expect(std::vector<std::string> arguments) {
    const tool::TemporaryFolder folder;
    tool::write_text(folder / "occluders.pov", kOccluders);
    arguments.insert(arguments.begin(), "+I" + (folder / "occluders.pov").string());
    expect_identical(arguments);
  }
};

INSTANTIATE_TEST_SUITE_P(Some, ImageIdenticalOccluders, ::testing::Values(6));
INSTANTIATE_TEST_SUITE_P(Slow, ImageIdenticalOccluders, ::testing::Values(1));

TEST_P(ImageIdenticalOccluders, OrdinaryCamera) { expect({"+W96", "+H72"}); }
TEST_P(ImageIdenticalOccluders, Sheet) {
  expect({"Lenticular=On", "Lens_Pixels=8", "+W96", "+H60"});
}
TEST_P(ImageIdenticalOccluders, OneLens) {
  expect({"Lenticular=On", "Lens_Pixels=24", "+W24", "+H60"});
}
TEST_P(ImageIdenticalOccluders, OnePixelALens) {
  expect({"Lenticular=On", "Lens_Pixels=1", "+W60", "+H48"});
}
TEST_P(ImageIdenticalOccluders, FractionalLenses) {
  expect({"Lenticular=On", "Lens_Pixels=7.37", "+W80", "+H48"});
}
TEST_P(ImageIdenticalOccluders, FiniteDistance) {
  expect({"Lenticular=On", "Lens_Pixels=6", "View_Distance=400", "+W72", "+H48"});
}

}  // namespace
}  // namespace lentray::test
