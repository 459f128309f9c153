// What the fuzzer once found, cut short: each input is read to its end or to a message, and nothing
// worse happens. Limits end what would not end.
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/fuzz/file_input.h"
#include "tests/fuzz/journal_input.h"
#include "tests/fuzz/mutator.h"
#include "tests/fuzz/read_input.h"
#include "tests/fuzz/text_input.h"
#include "tools/common/process.h"

namespace lentray::test {
namespace {

namespace fs = std::filesystem;

TEST(FuzzInputs, AllEnd) {
  const auto library = include_files("/usr/share/povray-3.7/include");
  std::size_t count = 0;
  for (const auto& entry :
       fs::directory_iterator(fs::path(LENTRAY_SOURCE_DIR) / "tests/fuzz/inputs")) {
    if (!entry.is_regular_file()) continue;
    SCOPED_TRACE(entry.path().filename().string());
    read_input(tool::read_text(entry.path()), library);
    ++count;
  }
  EXPECT_GT(count, 0u);
}

/// The sanitizers see leaks and reading beyond what there is.
TEST(FuzzInputs, OtherFilesAllEnd) {
  for (const auto& [folder, use] :
       {std::pair{"picture", &use_picture}, std::pair{"data", &use_data},
        std::pair{"ini", &use_ini}, std::pair{"manifest", &use_manifest},
        std::pair{"journal", &use_journal}}) {
    std::size_t count = 0;
    for (const auto& entry :
         fs::directory_iterator(fs::path(LENTRAY_SOURCE_DIR) / "tests/fuzz/inputs" / folder)) {
      SCOPED_TRACE(entry.path().filename().string());
      const std::string bytes = tool::read_text(entry.path());
      use(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
      ++count;
    }
    EXPECT_GT(count, 0u) << folder;
  }
}

TEST(FuzzMutator, KeepsWithinTheLengthAndTheVocabulary) {
  const std::string scene = "#declare A_ = <1, .5e3, 2>; sphere { A_, \"a b\\\"\" }";
  const auto pieces = pieces_of(scene);
  ASSERT_EQ(pieces.size(), 17u);
  EXPECT_EQ(pieces[0], "#declare");
  EXPECT_EQ(pieces[6], ".5e3");
  EXPECT_EQ(pieces[15], "\"a b\\\"\"");
  for (std::uint32_t seed = 0; seed < 2000; ++seed) {
    EXPECT_LE(Mutator(seed).mutate(scene, 200).size(), 200u);
    EXPECT_LE(Mutator(seed).cross(scene, "box { 0, 1 }", 100).size(), 100u);
  }
  EXPECT_EQ(Mutator(7).mutate(scene, 200), Mutator(7).mutate(scene, 200));
}

}  // namespace
}  // namespace lentray::test
