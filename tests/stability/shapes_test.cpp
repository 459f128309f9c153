// tests/stability/shapes.py: shapes in hard settings have no more wrong pixels than in stock's picture
// of the same scene. A few always, all of them with SlowStabilityShapes.
#include <gtest/gtest.h>

#include "tests/support/render.h"
#include "tools/common/process.h"

namespace lentray::stability {
namespace {

testing::AssertionResult no_worse_than_stock(const std::vector<std::string>& words,
                                             double seconds) {
  std::vector<std::string> command = {
      "python3",   (test::source_folder() / "tests/stability/shapes.py").string(),
      "--no-docs", "--check",
      "--bin",     test::program("lentray").parent_path().string()};
  command.insert(command.end(), words.begin(), words.end());
  const tool::RunResult result = tool::run_program(command, {}, seconds);
  if (result.status == 0) return testing::AssertionSuccess();
  return testing::AssertionFailure() << result.output;
}

TEST(StabilityShapes, GrazingRaysAndThinTori) {
  EXPECT_TRUE(no_worse_than_stock({"grazing,thin"}, 300.0));
}

TEST(StabilityShapes, FarAwayAndSmall) {
  EXPECT_TRUE(no_worse_than_stock(
      {"far,camera,scale", "1e7,1e-6", "sphere,box,torus,blob,lathe_cubic"}, 300.0));
}

// Shadows of what is near are there too; stock asks for them from a thousandth of a unit on.
TEST(StabilityShapes, SmallScenes) {
  EXPECT_TRUE(no_worse_than_stock({"scene", "1e-2,1e-4", "sphere,julia_fractal,text"}, 300.0));
}

class SlowStabilityShapes : public ::testing::TestWithParam<const char*> {};

TEST_P(SlowStabilityShapes, NoWorseThanStock) {
  EXPECT_TRUE(no_worse_than_stock({GetParam()}, 1500.0));
}

// By kind of setting, and so small that each takes a few minutes.
INSTANTIATE_TEST_SUITE_P(Each, SlowStabilityShapes,
                         ::testing::Values("plain,scene", "scale", "far", "camera", "axis", "plane",
                                           "inside,surface", "gap", "grazing,thin,degenerate"));

}  // namespace
}  // namespace lentray::stability
