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
  for (const char* order : {"rows", "columns"}) {
    for (const char* cache : {"off", "last", "depth"}) {
      for (const int threads : {1, 2, 5}) {
        std::vector<std::string> arguments = scene;
        const std::vector<std::string> way{std::string("Pixel_Order=") + order,
                                           std::string("Shadow_Cache=") + cache,
                                           "+WT" + std::to_string(threads)};
        arguments.insert(arguments.end(), way.begin(), way.end());
        arguments.insert(arguments.end(), {"+Oa.png", "+FN16", "-V"});
        const diff::RunResult result = run_lentray(arguments, folder.path());
        ASSERT_EQ(result.status, 0) << result.output;
        const StoredImage picture = core::read_image(folder / "a.png");
        if (first.samples.empty()) first = picture;
        ASSERT_TRUE(same_bits(first, picture)) << way[0] << " " << way[1] << " " << way[2];
      }
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

/// A plate just above a floor, nearer than the shadow tolerance: here a cache whose test differs
/// from the full search lets the order of pixels show.
TEST(ImageIdentical, PlateJustAboveAFloor) {
  const diff::TemporaryFolder folder;
  diff::write_text(folder / "plate.pov", R"(#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0,4,-4> look_at 0 }
light_source { <3,8,-2> rgb 1 }
plane { y, 0 pigment { rgb 1 } }
box { <-1,0.0006,-1>, <1,0.05,1> pigment { rgb 0.5 } no_image }
sphere { <0.4,0.8,0>, 0.3 pigment { rgb <1,0,0> } }
)");
  expect_identical({"+I" + (folder / "plate.pov").string(), "+W80", "+H60"});
}

}  // namespace
}  // namespace lentray::test
