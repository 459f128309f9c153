// lentray-model as a program: files that appear whole or not at all, charts, exit statuses.
#include <gtest/gtest.h>

#include <fstream>

#include "tests/support/render.h"

namespace lentray::test {
namespace {

namespace fs = std::filesystem;

class ImageModelProgram : public ::testing::Test {
 protected:
  tool::RunResult run(std::vector<std::string> words) const {
    words.insert(words.begin(), program("lentray-model").string());
    return tool::run_program(words, m_folder.path(), 300);
  }
  std::size_t files() const {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(m_folder.path()), fs::directory_iterator()));
  }
  const tool::TemporaryFolder m_folder;
};

TEST_F(ImageModelProgram, CsvAndMeasuring) {
  const auto result = run({"Lens_Pixels=5", "Lenses=21", "Rows=60", "A=0.5:4:1", "D=0:8:4",
                           "Ystart=-2", "CSV=out.csv", "--measure"});
  EXPECT_EQ(result.status, 0) << result.output;
  EXPECT_NE(result.output.find("measured equals enumerated at 60 of 60 points"), std::string::npos)
      << result.output;
  const std::string csv = tool::read_text(m_folder / "out.csv");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 61);
  EXPECT_EQ(files(), 1u) << "nothing is left beside it";
}

TEST_F(ImageModelProgram, CsvToStandardOutput) {
  const auto result = run({"A=20", "D=13", "CSV=-"});
  EXPECT_EQ(result.status, 0);
  EXPECT_NE(result.output.find("\nviews,20,13,0.3,17,18,\n"), std::string::npos) << result.output;
}

TEST_F(ImageModelProgram, ChartsOfEveryKind) {
  const auto result = run({"Lens_Pixels=5", "Lenses=21", "Rows=60", "A=0.5:4:1", "D=0:8:4",
                           "Ystart=-2", "Slice_A=3", "Figures=10,11,16,23,24d,near,wide"});
  EXPECT_EQ(result.status, 0) << result.output;
  for (const char* name : {"10", "11", "16", "23", "24d", "near", "wide"}) {
    const StoredImage chart = core::read_image(m_folder / ("figure-" + std::string(name) + ".png"));
    EXPECT_GT(chart.width, 800u) << name;
  }
  EXPECT_EQ(tool::read_text(m_folder / "figure-11.csv").substr(0, 18), "\"A, mm\",rows print");
  const auto svg = run({"Figures=13", "Format=svg"});
  EXPECT_EQ(svg.status, 0) << svg.output;
  EXPECT_NE(tool::read_text(m_folder / "figure-13.svg").find("<svg"), std::string::npos);
}

TEST_F(ImageModelProgram, WithoutFilesATable) {
  const auto result = run({"A=1:9:4", "D=1:9:4"});
  EXPECT_EQ(result.status, 0);
  EXPECT_NE(result.output.find("equation minus enumeration"), std::string::npos);
  EXPECT_NE(result.output.find("theta >= alpha"), std::string::npos);
}

TEST_F(ImageModelProgram, ErrorsLeaveWhatWasThere) {
  tool::write_text(m_folder / "out.csv", "mine");
  for (const std::vector<std::string>& words : {std::vector<std::string>{"CSV=out.csv", "A=x"},
                                                {"CSV=out.csv", "Deviations=nowhere/d.csv"},
                                                {"CSV=out.csv", "Figures=10", "Folder=nowhere"},
                                                {"CSV=out.csv", "Figures=10", "A=3"},
                                                {"CSV=out.csv", "Lens=3"}}) {
    const auto result = run(words);
    EXPECT_EQ(result.status, 1) << words.back();
    EXPECT_EQ(result.output.substr(0, 15), "lentray-model: ") << result.output;
    EXPECT_EQ(tool::read_text(m_folder / "out.csv"), "mine");
  }
  EXPECT_EQ(run({"CSV=/dev/full", "A=1", "D=1"}).status, 1) << "a full disk";
  EXPECT_EQ(files(), 1u);
}

TEST_F(ImageModelProgram, Help) {
  const auto result = run({"--help"});
  EXPECT_EQ(result.status, 0);
  EXPECT_NE(result.output.find("Lens_Focal_Length"), std::string::npos);
}

TEST_F(ImageModelProgram, NumbersOfOrdersAreJudgedBeforeTheScene) {
  const auto result = run_lentray({"+Inowhere.pov", "Pixel_Order=strips(0,3)"}, m_folder.path());
  EXPECT_EQ(result.status, 1);
  tool::write_text(m_folder / "a.pov", "#version 3.7;\n#error \"read\"\n");
  const auto order = run_lentray({"+Ia.pov", "Pixel_Order=strips(0,3)"}, m_folder.path());
  EXPECT_EQ(order.status, 1);
  EXPECT_NE(order.output.find("strips takes a width and a height"), std::string::npos)
      << order.output;
}

}  // namespace
}  // namespace lentray::test
