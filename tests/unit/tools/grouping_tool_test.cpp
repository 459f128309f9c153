// lentray-grouping's command line and what it computes from counts and times.
#include <gtest/gtest.h>

#include "parser/options/ini.h"
#include "tools/common/process.h"
#include "tools/lentray-grouping/report.h"

namespace lentray::grouping {
namespace {

using GroupingToolWords = std::vector<std::string>;

class UnitGroupingTool : public ::testing::Test {
 protected:
  void SetUp() override { tool::write_text(m_folder / "a.pov", "#version 3.7;\n"); }
  std::string scene() const { return (m_folder / "a.pov").string(); }
  std::string error_of(const GroupingToolWords& words) const {
    try {
      parse_arguments(words);
    } catch (const parser::OptionError& e) {
      return e.what();
    }
    return "no error";
  }
  const tool::TemporaryFolder m_folder;
};

TEST_F(UnitGroupingTool, Arguments) {
  const Arguments a =
      parse_arguments({scene(), "+W30", "Lenticular=On", "orders=rows,strips(4,8),hilbert",
                       "Caches=last", "Accelerators=list,buffer", "Repeats=2", "Declare=Size=3",
                       "x.ini[small]", "CSV=a.csv", "HTML=a.html"});
  EXPECT_EQ(a.scenes, GroupingToolWords{scene()});
  EXPECT_EQ(a.orders, (GroupingToolWords{"rows", "strips(4,8)", "hilbert"}));
  EXPECT_EQ(a.caches, GroupingToolWords{"last"});
  EXPECT_EQ(a.accelerators, (GroupingToolWords{"list", "buffer"}));
  EXPECT_EQ(a.repeats, 2);
  EXPECT_EQ(a.for_lentray,
            (GroupingToolWords{"+W30", "Lenticular=On", "Declare=Size=3", "x.ini[small]"}));
  EXPECT_EQ(a.csv, "a.csv");
  EXPECT_EQ(a.html, "a.html");
}

TEST_F(UnitGroupingTool, OwnOptionsAreLong) {
  const Arguments a = parse_arguments(
      {"--orders", "rows,strips(4,8)", scene(), "--csv=a.csv", "--sizes", "2,3", "-UL"});
  EXPECT_EQ(a.orders, (GroupingToolWords{"rows", "strips(4,8)"}));
  EXPECT_EQ(a.csv, "a.csv");
  EXPECT_EQ(a.sizes, (GroupingToolWords{"2", "3"}));
  EXPECT_EQ(a.scenes, GroupingToolWords{scene()});
  EXPECT_EQ(a.for_lentray, GroupingToolWords{"-UL"});
  EXPECT_EQ(error_of({scene(), "--csv"}), "--csv needs a value");
  EXPECT_EQ(error_of({scene(), "--repeats", "x"}),
            "option --repeats x: a whole number is expected");
}

TEST_F(UnitGroupingTool, Lists) {
  EXPECT_EQ(list_of("a,b(1,2),c"), (GroupingToolWords{"a", "b(1,2)", "c"}));
  EXPECT_EQ(list_of("a"), GroupingToolWords{"a"});
  EXPECT_EQ(list_of(",a,"), (GroupingToolWords{"", "a", ""}));
  EXPECT_TRUE(list_of("").empty());
}

TEST_F(UnitGroupingTool, Errors) {
  EXPECT_EQ(error_of({}), "no scene given");
  EXPECT_EQ(error_of({"nowhere.pov"}), "there is no scene 'nowhere.pov'");
  EXPECT_NE(error_of({scene(), "Orders="}).find("a list of names"), std::string::npos);
  EXPECT_NE(error_of({scene(), "Orders=rows,"}).find("a list of names"), std::string::npos);
  EXPECT_NE(error_of({scene(), "Repeats=-1"}).find("from 0 to 1000"), std::string::npos);
  EXPECT_NE(error_of({scene(), "Pixel_Order=rows"}).find("--orders"), std::string::npos);
  EXPECT_EQ(error_of({scene(), "--fast"}), "unknown option '--fast'; --help lists all");
}

Trial trial(const char* order, std::uint64_t hits, std::vector<double> cpu_s) {
  Trial t;
  t.scene = "scenes/a.pov";
  t.order = order;
  t.cache = "last";
  t.accelerator = "bvh";
  t.cpu_s = std::move(cpu_s);
  t.rays = 1000;
  t.blocked = 500;
  t.pairs = 20;
  t.most_hits = 480;
  t.hits = hits;
  t.miss_tests = 20 * (t.rays - hits);  // Cm = 20
  t.tests = t.miss_tests + hits;        // Ch = 1
  t.runs = 50;
  t.longest_run = 99;
  return t;
}

TEST_F(UnitGroupingTool, FiguresOfATrial) {
  const Trial t = trial("rows", 240, {3.0, 1.0, 2.0});
  EXPECT_EQ(t.median(), 2.0);
  EXPECT_EQ(t.least(), 1.0);
  EXPECT_EQ(t.most(), 3.0);
  EXPECT_EQ(trial("rows", 0, {4.0, 1.0}).median(), 2.5);
  EXPECT_DOUBLE_EQ(t.hits_of_blocked(), 0.48);
  EXPECT_DOUBLE_EQ(t.hits_of_most(), 0.5);
  EXPECT_DOUBLE_EQ(t.miss_cost(), 20.0);
  EXPECT_DOUBLE_EQ(t.mean_run(), 10.0);
  Trial nothing;
  EXPECT_EQ(nothing.hits_of_blocked(), 0.0);
  EXPECT_EQ(nothing.tests_a_ray(), 0.0);
}

TEST_F(UnitGroupingTool, EquationTwoAgainstTime) {
  // A machine that needs 1 s besides, and 1e-4 s a test.
  const auto seconds = [](std::uint64_t hits) {
    return 1.0 + 1e-4 * static_cast<double>(20 * (1000 - hits) + hits);
  };
  const Group group{trial("rows", 100, {seconds(100)}), trial("views", 50, {seconds(50)}),
                    trial("columns", 400, {seconds(400)})};
  const CostFit fit = fit_cost(group);
  EXPECT_NEAR(fit.rest, 1.0, 1e-9);
  EXPECT_NEAR(fit.per_test, 1e-4, 1e-12);
  const auto gains = gains_of(group);
  ASSERT_EQ(gains.size(), 2u);
  EXPECT_EQ(gains[0].against, "rows");
  EXPECT_EQ(gains[1].against, "views");
  EXPECT_DOUBLE_EQ(gains[0].miss_cost, 20.0);
  EXPECT_NEAR(gains[0].time, 1.0 - seconds(400) / seconds(100), 1e-12);
  EXPECT_NEAR(gains[0].tests, 1.0 - 12400.0 / 18100.0, 1e-12);
  // Equation 2 leaves Ch out: 600 misses for 900.
  EXPECT_NEAR(gains[0].equation2, 1.0 - 600.0 / 900.0, 1e-12);
  EXPECT_NEAR(gains[1].equation2, 1.0 - 600.0 / 950.0, 1e-12);
  EXPECT_TRUE(gains_of({trial("rows", 1, {1.0})}).empty());
}

TEST_F(UnitGroupingTool, Csv) {
  Trial t = trial("strips(4,8)", 240, {2.0});
  t.same_picture = false;
  const std::string csv = csv_of({t});
  EXPECT_NE(
      csv.find("\nscenes/a.pov,,\"strips(4,8)\",last,bvh,2,2,2,1000,500,240,20,480,0.48,0.5,"),
      std::string::npos)
      << csv;
  EXPECT_NE(csv.find(",10,99,no\n"), std::string::npos);
  EXPECT_NE(table_of({t}).find("DIFFERS"), std::string::npos);
}

TEST_F(UnitGroupingTool, WhoIsFastestAndHowFarAutoIs) {
  Trial fast = trial("columns", 240, {1.9, 2.0, 2.2}),
        decided = trial("auto", 240, {2.03, 2.1, 2.02});
  decided.cache = "auto";
  EXPECT_NE(
      table_of({fast, decided})
          .find("fastest: columns, last, 2.000 s (1.900 to 2.200); auto, auto takes 1.5 % more\n"),
      std::string::npos)
      << table_of({fast, decided});
  decided.cpu_s = {1.9};
  EXPECT_NE(table_of({fast, decided}).find("fastest: auto, auto, 1.900 s (1.900 to 1.900)\n"),
            std::string::npos);
  EXPECT_EQ(table_of({trial("rows", 240, {})}).find("fastest"), std::string::npos);
}

TEST_F(UnitGroupingTool, GroupsAreSceneAndAccelerator) {
  Trial a = trial("rows", 1, {1}), b = a, c = a;
  b.accelerator = "list";
  c.scene = "b.pov";
  EXPECT_EQ(groups_of({a, a, b, c}).size(), 3u);
}

}  // namespace
}  // namespace lentray::grouping
