// lentray-chart: which settings are on the front, which one is chosen, and what the table says of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <sstream>

#include "tools/lentray-chart/front.h"
#include "tools/lentray-chart/table.h"

namespace lentray::chart {
namespace {

Point point(const std::string& id, double seconds, double rms, Kind kind = Kind::antialiasing) {
  Point p{{id, "label of " + id, kind, {"+R" + id}}};
  p.state = State::done;
  p.cpu_s = {seconds};
  p.error = Error{};
  p.error->rms = rms;
  p.error->psnr = rms > 0.0 ? 40.0 : std::numeric_limits<double>::infinity();
  return p;
}

/// Times and errors on a coarse grid, so that many are equal.
Chart random_chart(std::mt19937& random) {
  std::uniform_int_distribution<int> size(0, 12), step(1, 6), which(0, 9);
  Chart chart;
  chart.command = "lentray a.pov";
  for (int i = size(random); i > 0; --i) {
    Point p = point(std::to_string(i), step(random) * 0.5, step(random) * 0.25,
                    which(random) == 0 ? Kind::lens_model : Kind::antialiasing);
    if (which(random) == 0) p.error.reset();
    if (which(random) == 0) p.state = State::failed;
    chart.points.push_back(p);
  }
  return chart;
}

bool counts(const Point& p) { return p.state == State::done && p.error.has_value(); }

TEST(UnitChartFront, IsWhatNoOtherSettingBeats) {
  std::mt19937 random(1);
  int on_front = 0, dominated = 0;
  for (int trial = 0; trial < 500; ++trial) {
    Chart chart = random_chart(random);
    derive(chart);
    for (const Point& p : chart.points) {
      const Point* fastest = nullptr;
      for (const Point& q : chart.points) {
        if (!counts(p) || !counts(q)) continue;
        if ((p.setting.kind == Kind::lens_model) != (q.setting.kind == Kind::lens_model)) continue;
        const double dt = q.seconds() - p.seconds(), de = q.error->rms - p.error->rms;
        if (dt <= 0.0 && de <= 0.0 && (dt < 0.0 || de < 0.0) &&
            (fastest == nullptr || q.seconds() < fastest->seconds())) {
          fastest = &q;
        }
      }
      EXPECT_EQ(p.on_front, counts(p) && fastest == nullptr);
      EXPECT_EQ(p.dominated_by.empty(), fastest == nullptr);
      on_front += p.on_front;
      if (p.dominated_by.empty()) continue;
      ++dominated;
      const auto by = std::ranges::find_if(
          chart.points, [&](const Point& q) { return q.setting.id == p.dominated_by; });
      ASSERT_NE(by, chart.points.end());
      EXPECT_TRUE(by->seconds() <= p.seconds() && by->error->rms <= p.error->rms);
    }
  }
  EXPECT_GT(on_front, 500);
  EXPECT_GT(dominated, 500);
}

TEST(UnitChartFront, ASettingIsDominatedByTheFastestThatIsBetterInBoth) {
  Chart chart;
  chart.points = {point("slow", 9, 3), point("fast", 1, 2), point("exact", 2, 1),
                  point("as-fast", 1, 3)};
  derive(chart);
  EXPECT_EQ(chart.points[0].dominated_by, "fast");
  EXPECT_EQ(chart.points[3].dominated_by, "fast");
  EXPECT_TRUE(chart.points[1].on_front && chart.points[2].on_front);
  EXPECT_EQ(chart.points[0].command, " +Rslow");
}

/// Their times differ from the plain one's by chance, or by little.
TEST(UnitChartFront, ExactSettingsAreOnNoFrontAndChosenLast) {
  Chart chart;
  Point plain = point("plain", 2.0, 1.0, Kind::exact);
  plain.setting.is_plain = true;
  chart.points = {plain, point("rows", 1.9, 1.0, Kind::exact), point("coarse", 1.0, 3.0)};
  derive(chart);
  EXPECT_TRUE(chart.points[0].on_front && chart.points[2].on_front);
  EXPECT_FALSE(chart.points[1].on_front);
  EXPECT_EQ(chart.points[0].dominated_by + chart.points[1].dominated_by, "");
  EXPECT_EQ(choose_by_budget(chart, 5.0).point, &chart.points[0]);
  EXPECT_EQ(choose_by_budget(chart, 1.95).point, &chart.points[1]);
  EXPECT_EQ(choose_by_budget(chart, 1.5).point, &chart.points[2]);
  EXPECT_EQ(choose_by_error(chart, 1.0).point, &chart.points[0]);
}

TEST(UnitChartFront, ErrorsBelowTenTimesTheReferencesChangeAreNotToldApart) {
  Chart chart;
  chart.reference.change = 0.1;
  chart.lens_reference.emplace().change = 0.001;
  chart.points = {point("a", 1, 0.99), point("b", 1, 1.0), point("c", 1, 0.02, Kind::lens_model)};
  derive(chart);
  EXPECT_FALSE(chart.points[0].told_apart);
  EXPECT_TRUE(chart.points[1].told_apart);
  EXPECT_TRUE(chart.points[2].told_apart);
}

TEST(UnitChartFront, TheChoiceIsTheBestOfAll) {
  std::mt19937 random(2);
  int found = 0, none = 0;
  for (int trial = 0; trial < 500; ++trial) {
    Chart chart = random_chart(random);
    derive(chart);
    std::uniform_int_distribution<int> step(0, 7);
    const double seconds = step(random) * 0.5, rms = step(random) * 0.25;
    const Choice budget = choose_by_budget(chart, seconds), error = choose_by_error(chart, rms);
    bool fits_budget = false, fits_error = false;
    for (const Point& p : chart.points) {
      if (!counts(p) || p.setting.kind == Kind::lens_model) continue;
      if (p.seconds() <= seconds) {
        fits_budget = true;
        ASSERT_NE(budget.point, nullptr);
        EXPECT_LE(budget.point->seconds(), seconds);
        EXPECT_GE(p.error->rms, budget.point->error->rms);
      }
      if (p.error->rms <= rms) {
        fits_error = true;
        ASSERT_NE(error.point, nullptr);
        EXPECT_LE(error.point->error->rms, rms);
        EXPECT_GE(p.seconds(), error.point->seconds());
      }
    }
    EXPECT_EQ(budget.point != nullptr, fits_budget);
    EXPECT_EQ(error.point != nullptr, fits_error);
    EXPECT_EQ(budget.reason.empty(), fits_budget);
    EXPECT_EQ(error.reason.empty(), fits_error);
    if (budget.point) {
      EXPECT_TRUE(budget.point->on_front);
      EXPECT_EQ(budget.command, budget.point->command);
    }
    (fits_budget ? found : none) += 1;
  }
  EXPECT_GT(found, 100);
  EXPECT_GT(none, 50);
}

TEST(UnitChartFront, WhyNoneFitsIsSaid) {
  Chart chart;
  EXPECT_EQ(choose_by_budget(chart, 1).reason, "no setting has a time and an error");
  EXPECT_EQ(choose_by_error(chart, 1).reason, "no setting has a time and an error");
  chart.points = {point("a", 3, 0.5), point("b", 2, 4)};
  EXPECT_EQ(choose_by_budget(chart, 1.5).reason,
            "no setting renders within 1.5 s; the fastest, label of b, takes 2.0 s");
  EXPECT_EQ(choose_by_error(chart, 0.25).reason,
            "no setting has an error of at most 0.25/255; the least, 0.5/255, has label of a in "
            "3.0 s");
}

TEST(UnitChartFront, CommandsAreQuotedForAShell) {
  Chart chart;
  chart.command = "lentray 'my scene.pov'";
  Point p = point("a", 1, 1);
  p.setting.options = {"Declare=A=\"it's\"", "+A0.1"};
  chart.points = {p};
  derive(chart);
  EXPECT_EQ(chart.points[0].command, "lentray 'my scene.pov' 'Declare=A=\"it'\\''s\"' +A0.1");
}

TEST(UnitChartFront, StocksTimeIsItsMedian) {
  Chart chart;
  chart.points = {point("a", 1, 1), point("b", 1, 1)};
  chart.points[0].stock_runs = {5, 1, 3};
  derive(chart);
  EXPECT_EQ(chart.points[0].stock_cpu_s, 3.0);
  EXPECT_FALSE(chart.points[1].stock_cpu_s);
}

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

TEST(UnitChartTable, CsvHasARowASetting) {
  Chart chart;
  chart.command = "lentray a.pov";
  chart.points = {point("a", 2, 0.5), point("b", 3, 0.0),
                  Point{{"c", "l, \"c\"", Kind::media, {}}}};
  chart.points[0].cpu_s = {2, 1, 4};
  chart.points[0].error->perceived = 1.25;
  chart.points[0].error->seen = 0.375;
  chart.points[0].stock_runs = {7};
  chart.points[0].stock_error = Error{0.75, 50, 0, 1, {}};
  chart.points[0].from_stock = Error{0.125, 60, 0.5, 3, {}};
  chart.points[0].from_plain = Error{0.25, 55, 0.5, 2, {}};
  chart.points[0].picture = "pictures/a.png";
  chart.points[2].state = State::failed;
  chart.points[2].reason = "no such method";
  derive(chart);
  const std::vector<std::string> lines = lines_of(csv_of(chart));
  ASSERT_EQ(lines.size(), 4u);
  const auto commas = [](const std::string& s) { return std::ranges::count(s, ','); };
  EXPECT_EQ(commas(lines[0]), commas(lines[1]));
  EXPECT_EQ(commas(lines[0]), commas(lines[2]));
  EXPECT_EQ(
      lines[1],
      "a,antialiasing,label of a,+Ra,done,,2,1,4,3,0.5,40,0,0,1.25,0.375,yes,yes,,0.25,2,7,0.75,"
      "0.125,60,0.5,3,pictures/a.png,lentray a.pov +Ra");
  EXPECT_EQ(lines[2],
            "b,antialiasing,label of b,+Rb,done,,3,3,3,1,0,inf,0,0,,,yes,yes,,,,,,,,,,,"
            "lentray a.pov +Rb");
  EXPECT_EQ(lines[3],
            "c,media,\"l, \"\"c\"\"\",,failed,no such method,,,,0,,,,,,,yes,no,,,,,,,,,,,"
            "lentray a.pov");
}

TEST(UnitChartTable, TheFrontIsListedFastestFirst) {
  Chart chart;
  chart.points = {point("a", 3, 0.5), point("b", 1, 2), point("c", 4, 0.75),
                  point("d", 5, 0.1, Kind::lens_model)};
  derive(chart);
  const std::string table = front_table(chart);
  EXPECT_LT(table.find("label of b"), table.find("label of a"));
  EXPECT_EQ(table.find("label of c"), std::string::npos);
  EXPECT_LT(table.find("Lens models"), table.find("label of d"));
  EXPECT_EQ(front_table(Chart{}), "");
}

TEST(UnitChartFront, KindsHaveNames) {
  for (const char* name : {"lens_model", "antialiasing", "area_light", "focal_blur", "media",
                           "radiosity", "depth", "quality", "combined", "exact"}) {
    ASSERT_TRUE(kind_named(name)) << name;
    EXPECT_STREQ(name_of(*kind_named(name)), name);
  }
  EXPECT_FALSE(kind_named("colour"));
}

TEST(UnitChartFront, TheTimeIsTheMedian) {
  Point p;
  EXPECT_EQ(p.seconds() + p.least() + p.most(), 0.0);
  p.cpu_s = {5, 1, 2};
  EXPECT_EQ(p.seconds(), 2.0);
  p.cpu_s = {5, 1, 2, 3};
  EXPECT_EQ(p.seconds(), 2.5);
  EXPECT_EQ(p.least(), 1.0);
  EXPECT_EQ(p.most(), 5.0);
}

}  // namespace
}  // namespace lentray::chart
