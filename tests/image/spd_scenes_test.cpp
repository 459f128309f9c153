// The scenes of the Standard Procedural Databases at a small size against stock, through their own
// cameras and as integral images; and their published numbers of objects.
#include <gtest/gtest.h>

#include "tests/support/render.h"

namespace lentray::test {
namespace {

struct SpdScene {
  const char* name;
  int size;       ///< for the pictures
  int published;  ///< objects at the published size, as the compiled scene has them
};

void PrintTo(const SpdScene& scene, std::ostream* out) { *out << scene.name; }

class ImageSpd : public ::testing::TestWithParam<SpdScene> {
 protected:
  std::string file() const {
    return (source_folder() / "scenes" / (std::string("spd_") + GetParam().name + ".pov")).string();
  }
  void expect_match(std::vector<std::string> more) {
    std::vector<std::string> arguments{file(), "Declare=Size=" + std::to_string(GetParam().size),
                                       "--grade", "match"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const tool::TemporaryFolder folder;
    const tool::RunResult result = run_diff(arguments, folder.path());
    EXPECT_EQ(result.status, 0) << result.output;
  }
};

TEST_P(ImageSpd, OwnCameraMatchesStock) { expect_match({"+W90", "+H90"}); }

TEST_P(ImageSpd, IntegralMatchesStock) {
  expect_match({"Declare=Lenticular_Camera=1", "+W120", "+H90"});
}

TEST_P(ImageSpd, HasThePublishedObjects) {
  const tool::RunResult result = run_lentray({"+I" + file(), "--explain"});
  ASSERT_EQ(result.status, 0) << result.output;
  EXPECT_NE(
      result.output.find(" " + std::to_string(GetParam().published) + " after splitting unions"),
      std::string::npos)
      << result.output;
}

// rings 4200 + 4200 + wall; tree 4095 + 4095 + field; mount 2 * 4^6 + 4; teapot 64 n^2 - 8 n
// + n^2; balls 7381 + floor; gears 64 of 2 + 144 + floor.
INSTANTIATE_TEST_SUITE_P(Scenes, ImageSpd,
                         ::testing::Values(SpdScene{"rings", 3, 8401}, SpdScene{"tetra", 4, 4096},
                                           SpdScene{"tree", 6, 8191}, SpdScene{"mount", 4, 8196},
                                           SpdScene{"teapot", 3, 2292}, SpdScene{"balls", 2, 7382},
                                           SpdScene{"gears", 2, 9345}),
                         [](const auto& tested) { return std::string(tested.param.name); });

}  // namespace
}  // namespace lentray::test
