// Scenes of Debian's povray-examples as they lie, through their own cameras, against stock:
// tests/compat/scenes.py renders both and compares. Ten quick ones always, with SlowScenes all that
// are listed as matching.
#include <gtest/gtest.h>

#include "tests/support/render.h"
#include "tools/common/process.h"

namespace lentray::test {
namespace {

namespace fs = std::filesystem;

testing::AssertionResult listed_scenes_match(const fs::path& list, double seconds) {
  const tool::RunResult result =
      tool::run_program({"python3", (source_folder() / "tests/compat/scenes.py").string(), "--no-docs",
                 "--bin", program("lentray").parent_path().string(), "--list", list.string(),
                 "--grade", "match"},
                {}, seconds);
  if (result.status == 0) return testing::AssertionSuccess();
  return testing::AssertionFailure() << result.output;
}

TEST(ImageScenes, TenQuickOnesMatch) {
  const tool::TemporaryFolder folder;
  tool::write_text(folder / "list.txt",
                   "advanced/teapot/teapot2.pov\nadvanced/bwstripe.pov\ncamera/fisheye.pov\n"
                   "camera/perspective.pov\nincdemo/woods/teak.pov\nincdemo/shapes2.pov\n"
                   "objects/ttf1.pov\nobjects/quartic/piriform.pov\nobjects/superel1.pov\n"
                   "objects/prism2.pov\n");
  EXPECT_TRUE(listed_scenes_match(folder / "list.txt", 580.0));
}

TEST(SlowScenes, AllListedOnesMatch) {
  EXPECT_TRUE(
      listed_scenes_match(source_folder() / "tests/compat/scenes_that_match.txt", 3500.0));
}

}  // namespace
}  // namespace lentray::test
