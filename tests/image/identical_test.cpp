// The picture is the same, bit for bit, whatever the pixel order, shadow cache and threads.
#include <gtest/gtest.h>

#include "tests/support/render.h"

namespace lentray::test {
namespace {

namespace fs = std::filesystem;

/// Renders the scene in every way and holds each picture against the first.
void expect_identical(const std::vector<std::string>& scene) {
  const diff::TemporaryFolder folder;
  StoredImage first;
  // Bands as high as the picture, a row, odd, and more than a row of tiles.
  const std::vector<std::string> bands{"", "Band_Height=1", "Band_Height=7", "Band_Height=40"};
  constexpr int kThreads[] = {1, 2, 5};
  std::size_t run = 0;
  // Every order with every cache; bands and threads change from run to run, so that each meets
  // every order and every cache.
  for (const char* order :
       {"rows", "views", "columns", "combined(4)", "strips(3,7)", "tiles", "hilbert"}) {
    for (const char* cache : {"off", "last", "depth", "tree", "neighbourhood", "grid"}) {
      const int threads = kThreads[(run + run / 6) % std::size(kThreads)];
      std::vector<std::string> arguments = scene;
      const std::vector<std::string> way{std::string("Pixel_Order=") + order,
                                         std::string("Shadow_Cache=") + cache,
                                         "+WT" + std::to_string(threads),
                                         bands[(run + run / 12) % bands.size()]};
      ++run;
      arguments.insert(arguments.end(), way.begin(), way.end());
      arguments.insert(arguments.end(), {"+Oa.png", "+FN16", "-V"});
      const diff::RunResult result = run_lentray(arguments, folder.path());
      ASSERT_EQ(result.status, 0) << result.output;
      const StoredImage picture = core::read_image(folder / "a.png");
      if (first.samples.empty()) first = picture;
      ASSERT_TRUE(same_bits(first, picture))
          << way[0] << " " << way[1] << " " << way[2] << " " << way[3];
    }
  }
}

std::string scene_file(const char* name) { return "+I" + (source_folder() / "scenes" / name).string(); }

TEST(ImageIdentical, BallsIntegral) {
  expect_identical({scene_file("spd_balls.pov"), "Declare=Size=3", "Declare=Lenticular_Camera=1",
                    "+W150", "+H100"});
}

TEST(ImageIdentical, GearsIntegral) {
  expect_identical({scene_file("spd_gears.pov"), "Declare=Size=2", "Declare=Lenticular_Camera=1",
                    "+W150", "+H100"});
}

TEST(ImageIdentical, DemoIntegral) {
  expect_identical({scene_file("demo.pov"), "Lenticular=On", "+W120", "+H90"});
}

TEST(ImageIdentical, FractionalLensesIntegral) {
  expect_identical({scene_file("demo.pov"), "Lenticular=On", "Lens_Pixels=12.5", "+W120", "+H90"});
}

TEST(ImageIdentical, DemoInItsOwnCamera) {
  expect_identical({scene_file("demo.pov"), "+W120", "+H90"});
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
  rotate 90*x rotate 0.106*z translate ()" + std::to_string(height) + R"( + 0.00215)*y }
sphere { <0.4,0.8,0>, 0.3 pigment { rgb <1,0,0> } finish { reflection 0.5 } }
)";
}

TEST(ImageIdentical, PlateJustAboveAFloor) {
  const diff::TemporaryFolder folder;
  diff::write_text(folder / "plate.pov", plate_scene(0.0));
  expect_identical({"+I" + (folder / "plate.pov").string(), "+W80", "+H60"});
  expect_identical({"+I" + (folder / "plate.pov").string(), "Lenticular=On", "+W90", "+H60"});
  // The near end lets light through: without that the scene would prove nothing.
  const StoredImage low = lentray_render({.sdl = plate_scene(0.0), .arguments = {}, .files = {}});
  const StoredImage high = lentray_render({.sdl = plate_scene(0.01), .arguments = {}, .files = {}});
  EXPECT_GT(core::compare(low, high, core::Columns::all(low.width)).beyond_2, 30u);
}

}  // namespace
}  // namespace lentray::test
