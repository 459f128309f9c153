// lentray-grouping as a program, and the log of shadow rays that it works with.
#include <gtest/gtest.h>

#include <sstream>

#include "tests/support/render.h"

namespace lentray::test {
namespace {

/// A ball over a floor, and two lights.
constexpr const char* kGroupingProgramScene = R"(#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0,3,-6> look_at 0 }
light_source { <3,6,-2> rgb 1 }
light_source { <-5,6,-1> rgb 0.5 }
plane { y, -1 pigment { rgb 1 } }
sphere { 0, 1 pigment { rgb <1,0,0> } }
)";

class ImageGroupingProgram : public ::testing::Test {
 protected:
  void SetUp() override { tool::write_text(m_folder / "a.pov", kGroupingProgramScene); }
  tool::RunResult run(std::vector<std::string> words) const {
    words.insert(words.begin(), program("lentray-grouping").string());
    return tool::run_program(words, m_folder.path(), 300);
  }
  nlohmann::json shadow(const std::string& cache) const {
    const auto result =
        run_lentray({"+Ia.pov", "+W90", "+H60", "-F", "-V", "-UL", "+WT1", "Lenticular=On",
                     "Shadow_Log=On", "Statistics_File=s.json", "Shadow_Cache=" + cache},
                    m_folder.path());
    EXPECT_EQ(result.status, 0) << result.output;
    return nlohmann::json::parse(tool::read_text(m_folder / "s.json")).at("shadow");
  }
  const tool::TemporaryFolder m_folder;
};

TEST_F(ImageGroupingProgram, TableCsvAndPage) {
  const auto result = run(
      {"a.pov", "+W90", "+H60", "Lenticular=On", "Orders=rows,views,columns,strips(3,5)",
       "Caches=off,last", "Accelerators=bvh,list,buffer", "Repeats=1", "CSV=a.csv", "HTML=a.html"});
  EXPECT_EQ(result.status, 0) << result.output;
  EXPECT_NE(result.output.find("equation 2"), std::string::npos) << result.output;
  const std::string csv = tool::read_text(m_folder / "a.csv");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 4 * 2 * 3);
  EXPECT_EQ(csv.find(",no\n"), std::string::npos) << "a picture differs";
  const std::string page = tool::read_text(m_folder / "a.html");
  EXPECT_NE(page.find("<svg"), std::string::npos);
  EXPECT_NE(page.find("</html>"), std::string::npos);
}

TEST_F(ImageGroupingProgram, GainsOverSizesAndAccelerators) {
  const auto result =
      run({(source_folder() / "scenes/spd_balls.pov").string(), "Declare=Lenticular_Camera=1",
           "+W90", "+H60", "Orders=rows,columns", "Caches=last", "Accelerators=bvh,grid,list",
           "Sizes=1,2", "Repeats=0", "Gains=g.csv"});
  EXPECT_EQ(result.status, 0) << result.output;
  std::istringstream lines(tool::read_text(m_folder / "g.csv"));
  std::string line;
  std::vector<double> costs;
  std::getline(lines, line);
  while (std::getline(lines, line)) {
    std::istringstream fields(line);
    std::string field;
    for (int i = 0; i < 6; ++i) std::getline(fields, field, ',');
    costs.push_back(std::stod(field));
  }
  // bvh, grid, list of each size, against rows: Cm grows from one to the next.
  ASSERT_EQ(costs.size(), 6u);
  EXPECT_LT(costs[0], costs[2]);
  EXPECT_LT(costs[3], costs[5]);
  EXPECT_LT(costs[2], costs[5]);
}

TEST_F(ImageGroupingProgram, ColumnsSaveWhatThePaperSaysOnTheMosaic) {
  const auto result =
      run({(source_folder() / "scenes/mosaic.pov").string(), "+W150", "+H150", "-UL",
           "Orders=rows,views,columns", "Caches=last", "Sizes=40,60", "Repeats=0", "Gains=g.csv"});
  EXPECT_EQ(result.status, 0) << result.output;
  // size, accelerator, cache, against, Cm, blocked, hits of columns, of the other, saved, equation 2
  std::istringstream lines(tool::read_text(m_folder / "g.csv"));
  std::string line;
  std::getline(lines, line);
  int found = 0;
  while (std::getline(lines, line)) {
    std::vector<std::string> fields;
    std::istringstream row(line);
    for (std::string field; std::getline(row, field, ',');) fields.push_back(field);
    ASSERT_GE(fields.size(), 11u) << line;
    const double blocked = std::stod(fields[6]), columns = std::stod(fields[7]),
                 other = std::stod(fields[8]), saved = std::stod(fields[9]),
                 equation = std::stod(fields[10]);
    EXPECT_NEAR(blocked, std::stod(fields[1]) / 100, 0.02) << line;
    EXPECT_GT(columns, 0.95) << line;
    EXPECT_LT(other, 0.01) << line;
    EXPECT_GT(saved, fields[1] == "40" ? 0.41 : 0.60) << line;
    EXPECT_GT(equation, fields[1] == "40" ? 0.37 : 0.57) << line;
    ++found;
  }
  EXPECT_EQ(found, 4);
}

TEST_F(ImageGroupingProgram, ErrorsAreTold) {
  const auto order = run({"a.pov", "Orders=diagonal", "Repeats=1", "CSV=a.csv"});
  EXPECT_EQ(order.status, 1);
  EXPECT_NE(order.output.find("unknown pixel order"), std::string::npos) << order.output;
  EXPECT_FALSE(std::filesystem::exists(m_folder / "a.csv"));
  EXPECT_EQ(run({"a.pov", "CSV=nowhere/a.csv"}).status, 1);
  EXPECT_EQ(run({}).status, 1);
  EXPECT_EQ(run({"--help"}).status, 0);
}

TEST_F(ImageGroupingProgram, TheLogCountsWhatItSays) {
  const auto off = shadow("off"), last = shadow("last");
  const auto number = [](const nlohmann::json& j, const char* key) {
    return j.at(key).get<std::uint64_t>();
  };
  EXPECT_EQ(off.at("log").at("pairs"), 2) << "the ball, from two lights; the floor lies below";
  EXPECT_EQ(number(off.at("log"), "most_hits"), number(off, "blocked") - 2);
  // One occluder a light: a cache has every hit there can be.
  EXPECT_EQ(last.at("cache").at("hits"), last.at("log").at("most_hits"));
  EXPECT_EQ(off.at("log").at("tests"), off.at("log").at("miss_tests"));
  // A hit costs its probe.
  EXPECT_EQ(number(last.at("log"), "tests"),
            number(last.at("log"), "miss_tests") + number(last.at("cache"), "hits"));
  // Runs hold all blocked rays.
  std::uint64_t runs = 0, least = 0, most = 0, length = 1;
  for (const auto& count : off.at("log").at("runs").at("by_length")) {
    runs += count.get<std::uint64_t>();
    least += count.get<std::uint64_t>() * length;
    length *= 2;
    most += count.get<std::uint64_t>() * (length - 1);
  }
  EXPECT_EQ(runs, number(off.at("log").at("runs"), "count"));
  EXPECT_LE(least, number(off, "blocked"));
  EXPECT_GE(most, number(off, "blocked"));
}

TEST_F(ImageGroupingProgram, ALogNeedsAFile) {
  const auto result = run_lentray({"+Ia.pov", "-F", "Shadow_Log=On"}, m_folder.path());
  EXPECT_EQ(result.status, 1);
  EXPECT_NE(result.output.find("name a Statistics_File"), std::string::npos) << result.output;
}

}  // namespace
}  // namespace lentray::test
