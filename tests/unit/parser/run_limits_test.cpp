// Max_Files and Max_Pixels: what a scene opens, and what pictures a run makes.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "parser/files/counted_files.h"
#include "parser/options/options.h"
#include "tools/common/process.h"

namespace lentray::parser::test_run_limits {
namespace {

TEST(UnitRunLimits, AFileCountsEachTimeItIsOpened) {
  const tool::TemporaryFolder folder;
  tool::write_text(folder / "a", "x");
  const std::string a = (folder / "a").string(), b = (folder / "b").string();
  CountedFiles files(disk_files(), 3);
  EXPECT_EQ(files.read_scene(a), "x");
  EXPECT_TRUE(files.exists(a));
  EXPECT_FALSE(files.exists(b));
  EXPECT_EQ(files.read(a), "x");
  EXPECT_EQ(files.hold(a), a);
  EXPECT_TRUE(files.open(b, false));
  EXPECT_THROW(files.read(a), FileRefused);
  EXPECT_THROW(files.hold(a), FileRefused);
  EXPECT_THROW(files.open((folder / "c").string(), false), FileRefused);
  EXPECT_FALSE(files.exists((folder / "c").string()));
}

std::string refusal(const std::vector<std::string>& words) {
  try {
    check_pixels(read_options(words, {{}, {}, {}}));
  } catch (const OptionError& error) {
    return error.what();
  }
  return "";
}

TEST(UnitRunLimits, PixelsOfAllPicturesCount) {
  EXPECT_EQ(refusal({"a.pov", "+W100", "+H100"}), "");
  EXPECT_EQ(refusal({"a.pov", "+W100", "+H100", "Max_Pixels=10K"}), "");
  EXPECT_EQ(refusal({"a.pov", "+W100", "+H101", "Max_Pixels=10K"}),
            "100 x 101 pixels are more than the 10000 of Max_Pixels (+W100, +H101)");
  EXPECT_EQ(refusal({"a.pov", "+W10", "+H10", "+KFF100", "Max_Pixels=10K"}), "");
  EXPECT_EQ(refusal({"a.pov", "+W10", "+H10", "+KFF101", "Max_Pixels=10K"}),
            "101 pictures of 10 x 10 pixels are more than the 10000 of Max_Pixels (+W10, +H10, "
            "+KFF101)");
  EXPECT_EQ(refusal({"a.pov", "+W10", "+H10", "+KFF101", "+SF100", "Max_Pixels=10K"}), "");
}

/// An INI file that came with a scene asks for the picture, and has no say in the limit.
TEST(UnitRunLimits, AScenesIniDoesNotWidenThem) {
  const tool::TemporaryFolder folder;
  const std::string ini = (folder / "a.ini").string();
  tool::write_text(ini, "Width=2000\nHeight=2000\nMax_Pixels=1T\nMax_Files=9\nMax_Written=9G\n");
  const std::vector<std::string> words{"a.pov", "--scene-ini=" + ini, "Max_Pixels=1M",
                                       "Max_Files=3", "Max_Written=1M"};
  EXPECT_NE(refusal(words).find("2000 x 2000 pixels are more than the 1000000 of Max_Pixels (Width="
                                "2000 in " +
                                ini + ":1, "),
            std::string::npos)
      << refusal(words);
  const RenderOptions options = read_options(words, {{}, {}, {}});
  EXPECT_EQ(options.max_files, 3u);
  EXPECT_EQ(options.max_written, 1048576.0);
}

}  // namespace
}  // namespace lentray::parser::test_run_limits
