// parse_scenes.py: each example scene is read, or refused, as stock does it; scene_cases.py: so are
// small scenes of all dialects, and sloppy ones, with warnings of the same lines.
#include <gtest/gtest.h>

#include <filesystem>

#include "tools/common/process.h"

namespace lentray::test {
namespace {

TEST(SlowParseScenes, AsStock) {
  if (!std::filesystem::exists("/usr/share/doc/povray/examples")) {
    GTEST_SKIP() << "povray-examples is not installed";
  }
  const tool::RunResult run = tool::run_program(
      {"python3", LENTRAY_SOURCE_DIR "/tests/compat/parse_scenes.py", "--bin", LENTRAY_BIN_DIR}, {},
      3500.0);
  EXPECT_EQ(run.status, 0) << run.output;
}

TEST(SlowSceneCases, AsStock) {
  const tool::RunResult run = tool::run_program(
      {"python3", LENTRAY_SOURCE_DIR "/tests/compat/scene_cases.py", "--bin", LENTRAY_BIN_DIR}, {},
      3500.0);
  EXPECT_EQ(run.status, 0) << run.output;
}

}  // namespace
}  // namespace lentray::test
