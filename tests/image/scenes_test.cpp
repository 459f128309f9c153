// Scenes of Debian's povray-examples as they lie, through their own cameras, against stock, by lentray-batch.
// Ten quick ones always, with SlowScenes all that docs/scenes.md lists as exact or match.
#include <gtest/gtest.h>

#include <fstream>

#include "tests/support/render.h"
#include "tools/common/process.h"

namespace lentray::test {
namespace {

constexpr const char* kScenesExamples = "/usr/share/doc/povray/examples/";

/// Names as docs/scenes.md has them.
testing::AssertionResult all_match(const std::vector<std::string>& names, double seconds) {
  const tool::TemporaryFolder folder;
  std::vector<std::string> command{program("lentray-batch").string(),
                                   "--out",
                                   (folder / "out").string(),
                                   "+W160",
                                   "+H120",
                                   "-A",
                                   "--no-scene-ini",
                                   "--grade",
                                   "match"};
  for (const std::string& name : names) command.push_back(kScenesExamples + name + ".pov");
  const tool::RunResult result = tool::run_program(command, {}, seconds);
  if (result.status == 0) return testing::AssertionSuccess();
  return testing::AssertionFailure() << result.output;
}

/// Rows "| name | grade |..." whose grade is exact or match.
std::vector<std::string> listed_as_match() {
  std::ifstream page(source_folder() / "docs/scenes.md");
  std::vector<std::string> names;
  for (std::string line; std::getline(page, line);) {
    const std::size_t grade = line.find(" | ", 2);
    if (!line.starts_with("| ") || grade == std::string::npos) continue;
    const std::string rest = line.substr(grade + 3);
    if (rest.starts_with("exact | ") || rest.starts_with("match | "))
      names.push_back(line.substr(2, grade - 2));
  }
  return names;
}

TEST(ImageScenes, TenQuickOnesMatch) {
  EXPECT_TRUE(
      all_match({"advanced/teapot/teapot2", "advanced/bwstripe", "camera/fisheye",
                 "camera/perspective", "incdemo/woods/teak", "incdemo/shapes2", "objects/ttf1",
                 "objects/quartic/piriform", "objects/superel1", "objects/prism2"},
                580.0));
}

TEST(SlowScenes, AllListedOnesMatch) {
  const std::vector<std::string> names = listed_as_match();
  EXPECT_GT(names.size(), 300u) << "docs/scenes.md has another form";
  EXPECT_TRUE(all_match(names, 3500.0));
}

}  // namespace
}  // namespace lentray::test
