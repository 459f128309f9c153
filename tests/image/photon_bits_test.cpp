// Pictures with photons and subsurface light: the same bits in parts, from saved and loaded
// photons, and when a run was killed. Threads, orders, caches and bands: identical_test.cpp.
#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/pass_kills.h"
#include "tests/support/render.h"

namespace lentray::test {
namespace {

/// Photons on surfaces and in media, nested glass, subsurface light.
SceneText photon_bits_scene(const std::string& settings) {
  SceneText scene;
  scene.sdl = R"(#version 3.7;
global_settings { assumed_gamma 1 mm_per_unit 20 subsurface { samples 12, 4 } photons { )" +
              settings + R"( } }
camera { location <0, 2.5, -4.5> look_at <0, 0.4, 0> angle 45 }
light_source { <1.5, 5, -1> rgb 1 photons { reflection on refraction on } }
plane { y, 0 pigment { rgb <0.9, 0.85, 0.8> } }
sphere { <-0.5, 1.2, 0>, 0.5 pigment { rgbf <1, 0.9, 0.8, 0.95> } finish { reflection 0.1 }
  interior { ior 1.5 } photons { target reflection on refraction on } }
box { <-1.2, 0.01, -1>, <0.3, 0.6, 1> hollow pigment { rgbt 1 } photons { pass_through }
  interior { media { scattering { 1, 0.5 } samples 4 density { bozo scale 0.3 } } } }
sphere { <1.1, 0.5, 0>, 0.5 pigment { rgb <0.9, 0.6, 0.4> } interior { ior 1.3 }
  finish { ambient 0 subsurface { translucency 2 } } }
)";
  return scene;
}
constexpr const char* kFew = "spacing 0.05 media 10";

/// Each part of a picture shoots them anew, as tasks of a farm do.
TEST(ImagePhotonBits, PartsOfAPictureHaveTheSame) {
  const tool::TemporaryFolder folder;
  tool::write_text(folder / "a.pov", photon_bits_scene(kFew).sdl);
  const auto ours = [&](std::vector<std::string> words) {
    words.insert(words.begin(), {"+Ia.pov", "-V", "-A", "+W80", "+H60"});
    const tool::RunResult result = run_lentray(words, folder.path());
    EXPECT_EQ(result.status, 0) << result.output;
  };
  ours({"+Owhole.png"});
  const StoredImage whole = core::read_image(folder / "whole.png");
  for (const auto& [from, to] : {std::pair{1u, 25u}, std::pair{26u, 60u}}) {
    ours({"+Opart.png", "+SR" + std::to_string(from), "+ER" + std::to_string(to), "+WT1"});
    const StoredImage part = core::read_image(folder / "part.png");
    ASSERT_EQ(part.height, whole.height);
    std::size_t others = 0;
    for (std::uint32_t row = from - 1; row < to; ++row) {
      for (std::uint32_t column = 0; column < whole.width; ++column) {
        for (int c = 0; c < 3; ++c)
          others += part.at(column, row, c) == whole.at(column, row, c) ? 0 : 1;
      }
    }
    EXPECT_EQ(others, 0u) << from;
  }
}

/// In media too.
TEST(ImagePhotonBits, LoadedOnesGiveThePictureOfThoseThatWereSaved) {
  const tool::TemporaryFolder folder;
  const auto ours = [&](const char* file) {
    SceneText scene = photon_bits_scene(std::string(kFew) + " " + file + " \"" +
                                        (folder / "a.ph").string() + "\"");
    scene.arguments = {"Restrict_IO=Off"};
    return lentray_render(scene);
  };
  const StoredImage shot = ours("save_file");
  EXPECT_TRUE(same_bits(ours("load_file"), shot));
}

/// Kept records are there a second after the start at the earliest, so the pass takes a while.
TEST(SlowPhotonsGoingOn, KilledTwentyTimesTheyHaveTheBitsOfOneRun) {
  const tool::TemporaryFolder folder;
  tool::write_text(folder / "a.pov", photon_bits_scene("spacing 0.0012 media 4, 20").sdl);
  expect_bits_after_kills("80", "60", folder.path());
}

}  // namespace
}  // namespace lentray::test
