// lentray-merge as a program: bands that lentray renders, joined, are the file of the whole picture.
#include <gtest/gtest.h>

#include <set>

#include "tests/support/render.h"

namespace lentray::test {
namespace {

/// A ball over a floor; the sky above is black, as the rows outside of a band are.
constexpr const char* kMergeScene = R"(#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0,1,-5> look_at 0 right x*4/3 }
light_source { <5,8,-6> rgb 1 }
plane { y, -1 pigment { checker rgb 1 rgb <0.4,0.1,0.1> } }
sphere { 0, 1 pigment { rgb <1,0.6,0.1> } finish { reflection 0.3 phong 0.6 } }
)";

class ImageMerge : public ::testing::Test {
 protected:
  void SetUp() override { tool::write_text(m_folder / "a.pov", kMergeScene); }
  void render(const std::string& picture, std::vector<std::string> words) const {
    words.insert(words.end(), {"+Ia.pov", "+W120", "+H150", "-V", "+O" + picture});
    const auto result = run_lentray(words, m_folder.path());
    ASSERT_EQ(result.status, 0) << result.output;
  }
  tool::RunResult merge(std::vector<std::string> words) const {
    words.insert(words.begin(), program("lentray-merge").string());
    return tool::run_program(words, m_folder.path(), 100);
  }
  const tool::TemporaryFolder m_folder;
};

/// Options of the picture.
class ImageMergeOptions : public ImageMerge,
                          public ::testing::WithParamInterface<std::vector<std::string>> {};

TEST_P(ImageMergeOptions, SameFileAsTheWhole) {
  render("whole.png", GetParam());
  const std::pair<const char*, const char*> bands[] = {{"1", "47"}, {"48", "130"}, {"131", "150"}};
  for (int i = 0; i < 3; ++i) {
    std::vector<std::string> words = GetParam();
    words.push_back(std::string("+SR") + bands[i].first);
    words.push_back(std::string("+ER") + bands[i].second);
    render("part" + std::to_string(i) + ".png", words);
  }
  const auto result = merge(
      {"part2.png", "part0.png", "part1.png", "--rows", "131-150,1-47,48-130", "--out", "m.png"});
  EXPECT_EQ(result.status, 0) << result.output;
  EXPECT_EQ(result.output, "");
  EXPECT_EQ(tool::read_text(m_folder / "m.png"), tool::read_text(m_folder / "whole.png"));
}

using MergeWords = std::vector<std::string>;
INSTANTIATE_TEST_SUITE_P(
    Options, ImageMergeOptions,
    ::testing::Values(MergeWords{}, MergeWords{"+A", "-J"}, MergeWords{"+A", "+AM2", "+R2"},
                      MergeWords{"+FN16"}, MergeWords{"+FN10", "+UA"},
                      MergeWords{"Grayscale_Output=On"}, MergeWords{"File_Gamma=1.8"},
                      MergeWords{"Dither=On", "Dither_Method=B4"},
                      MergeWords{"Lenticular=On", "Lens_Pixels=8"},
                      MergeWords{"Lenticular=On", "Lens_Pixels=8", "+A0.1", "+AM3"},
                      MergeWords{"Lenticular=On", "Lens_Pixels=8", "+A", "+FN16", "+UA"}));

TEST_F(ImageMerge, BlackRowsNeedToBeTold) {
  render("upper.png", {"+SR1", "+ER100"});
  render("lower.png", {"+SR101", "+ER150"});
  const auto untold = merge({"upper.png", "lower.png", "--out", "m.png"});
  EXPECT_EQ(untold.status, 1);
  EXPECT_NE(untold.output.find("lentray-merge: cannot make 'm.png': rows 1 to "), std::string::npos)
      << untold.output;
  EXPECT_FALSE(std::filesystem::exists(m_folder / "m.png"));
  const auto missing = merge({"upper.png", "lower.png", "--rows=1-90,101-150", "--out", "m.png"});
  EXPECT_EQ(missing.status, 1);
  EXPECT_EQ(missing.output, "lentray-merge: cannot make 'm.png': rows 91 to 100 are in no part\n");
  EXPECT_EQ(merge({"upper.png", "lower.png", "--rows=1-100,101-150", "--out=m.png"}).status, 0);
}

TEST_F(ImageMerge, NothingIsLeftOfWhatFails) {
  render("a.png", {"+SR1", "+ER100"});
  tool::write_text(m_folder / "m.png", "older");
  render("b.png", {"+SR90", "+ER150", "Declare=unused=1", "File_Gamma=1.5"});
  const auto result = merge({"a.png", "b.png", "--rows=1-100,90-150", "--out", "m.png"});
  EXPECT_EQ(result.status, 1);
  EXPECT_EQ(result.output,
            "lentray-merge: 'a.png' and 'b.png' are not parts of one picture: they differ in their "
            "gamma\n");
  EXPECT_EQ(tool::read_text(m_folder / "m.png"), "older");
  std::set<std::string> files;
  for (const auto& file : std::filesystem::directory_iterator(m_folder.path()))
    files.insert(file.path().filename());
  EXPECT_EQ(files, (std::set<std::string>{"a.pov", "a.png", "b.png", "m.png"}));
}

}  // namespace
}  // namespace lentray::test
