// lentray-model's command line, its CSV, its table of deviations and its sweeps.
#include <gtest/gtest.h>

#include <sstream>

#include "parser/options/ini.h"
#include "tools/common/csv.h"
#include "tools/lentray-model/deviations.h"
#include "tools/lentray-model/figures.h"
#include "tools/lentray-model/sweeps.h"

namespace lentray::model {
namespace {

using ModelToolWords = std::vector<std::string>;

std::string model_tool_error_of(const ModelToolWords& words) {
  try {
    parse_arguments(words);
  } catch (const parser::OptionError& e) {
    return e.what();
  }
  return "no error";
}

TEST(UnitModelTool, ArgumentsOfTheIssue) {
  const Arguments a =
      parse_arguments({"Lens_Pitch=1.1", "Lens_Focal_Length=3", "Lens_IOR=1.5", "Lens_Pixels=10",
                       "lenses=50", "A=0.5:40:1", "D=0:40:1", "XSTART=0.2", "CSV=out.csv"});
  EXPECT_EQ(a.lens.pitch, 1.1);
  EXPECT_EQ(a.lens.focal_length, 3.0);
  EXPECT_EQ(a.lens.ior, 1.5);
  EXPECT_EQ(a.lens.pixels, 10.0);
  EXPECT_EQ(a.lenses, 50u);
  EXPECT_EQ(a.a.values().size(), 40u);
  EXPECT_EQ(a.a.values().back(), 39.5);
  EXPECT_EQ(a.d.values().size(), 41u);
  EXPECT_EQ(a.d.values().back(), 40.0);
  EXPECT_EQ(a.x, 0.2);
  EXPECT_EQ(a.start_down(), 0.2) << "as Xstart";
  EXPECT_EQ(a.csv, "out.csv");
  EXPECT_FALSE(a.measure);
}

TEST(UnitModelTool, OtherArguments) {
  const Arguments a = parse_arguments({"Ystart=-3", "Rows=100", "Alpha=Refracted", "Lens_LPI=25.4",
                                       "A=2", "D=1:3", "Strip_Width=2,3", "Strip_Height=4",
                                       "Figures=24a,Near", "Format=SVG", "--measure", "Threads=3"});
  EXPECT_EQ(a.start_down(), -3.0);
  EXPECT_EQ(a.rows, 100u);
  EXPECT_EQ(a.alpha, shadow::paper::Alpha::kRefracted);
  EXPECT_DOUBLE_EQ(a.lens.pitch, 1.0);
  EXPECT_EQ(a.a.values(), std::vector<double>{2.0});
  EXPECT_EQ(a.d.values(), (std::vector<double>{1.0, 2.0, 3.0}));
  EXPECT_EQ(a.figures, (ModelToolWords{"24a", "near"}));
  EXPECT_EQ(a.format, "svg");
  EXPECT_TRUE(a.measure);
  EXPECT_EQ(a.threads, 3);
  ModelToolWords names;
  for (const shadow::Style& style : a.styles()) names.push_back(style.name());
  EXPECT_EQ(names, (ModelToolWords{"rows", "views", "columns", "combined", "strips", "combined(2)",
                                   "combined(3)", "strips(2,4)", "strips(3,4)"}));
  EXPECT_EQ(parse_arguments({"Figures=all"}).figures, figure_names());
}

TEST(ErrorModelTool, EachWithAMessage) {
  EXPECT_EQ(model_tool_error_of({"Lens_Pitch=0"}).substr(0, 19), "option Lens_Pitch=0");
  EXPECT_NE(model_tool_error_of({"Lens_Pitch=x"}).find("a number is expected"), std::string::npos);
  EXPECT_NE(model_tool_error_of({"A=3:1:1"}).find("the last value is less than the first"),
            std::string::npos);
  EXPECT_NE(model_tool_error_of({"A=0:1:1"}).find("a shadow larger than 0 mm"), std::string::npos);
  EXPECT_NE(model_tool_error_of({"D=-1"}).find("a distance of 0 mm or more"), std::string::npos);
  EXPECT_NE(model_tool_error_of({"A=1:2:0"}).find("greater than 0"), std::string::npos);
  EXPECT_NE(model_tool_error_of({"A=1:2:3:4"}).find("first:last:step"), std::string::npos);
  EXPECT_NE(model_tool_error_of({"A="}).find("first:last:step"), std::string::npos);
  EXPECT_NE(model_tool_error_of({"A=1:"}).find("a number is expected"), std::string::npos);
  EXPECT_NE(model_tool_error_of({"A=1:1e9:1"}).find("more than 100000 values"), std::string::npos);
  EXPECT_NE(model_tool_error_of({"A=1:9999:1", "D=0:9999:1"}).find("1000000 points"),
            std::string::npos);
  EXPECT_NE(model_tool_error_of({"Lens_IOR=0.9"}).find("at least 1"), std::string::npos);
  EXPECT_NE(model_tool_error_of({"Lens_Pixels=0.5"}).find("at least one pixel"), std::string::npos);
  EXPECT_NE(model_tool_error_of({"Lenses=900000"}).find("too large"), std::string::npos);
  EXPECT_NE(model_tool_error_of({"Figures=18"}).find("there are 10, 11, 12"), std::string::npos);
  EXPECT_NE(model_tool_error_of({"Format=gif"}).find("there are png, svg"), std::string::npos);
  EXPECT_NE(model_tool_error_of({"Strip_Height=3"}).find("needs a --strip-width"),
            std::string::npos);
  EXPECT_EQ(model_tool_error_of({"Lens_Pich=1"}).substr(0, 33),
            "unknown option 'Lens_Pich'; there");
  EXPECT_EQ(model_tool_error_of({"--csv"}), "--csv needs a value");
  EXPECT_EQ(model_tool_error_of({"--strip-height", "3"}), "--strip-height needs a --strip-width");
  EXPECT_EQ(model_tool_error_of({}), "no error");
}

Grid small_grid(const Arguments& a, const shadow::PaperSheet& sheet, bool measured) {
  return make_grid(a, sheet, a.styles(), [=](const shadow::Style&) { return measured; }, {});
}

TEST(UnitModelTool, Csv) {
  const Arguments a =
      parse_arguments({"Lens_Pixels=5", "Lenses=41", "Rows=60", "A=1:2:1", "D=0:13:13", "Ystart=-2",
                       "Strip_Width=2", "Strip_Height=4"});
  const shadow::PaperSheet sheet(a.lens, a.lenses, a.rows);
  std::istringstream plain(csv_of(small_grid(a, sheet, false), a));
  std::istringstream measured(csv_of(small_grid(a, sheet, true), a));
  std::string line, with;
  std::getline(plain, line);
  EXPECT_EQ(line, "style,A,D,xstart,closed_form,enumerated,measured");
  std::getline(measured, with);
  ModelToolWords lines;
  while (std::getline(plain, line)) {
    lines.push_back(line);
    ASSERT_EQ(line.back(), ',') << "nothing measured";
    std::getline(measured, with);
    // What was measured is what was enumerated.
    const std::size_t comma = line.rfind(',', line.size() - 2);
    EXPECT_EQ(with, line + line.substr(comma + 1, line.size() - comma - 2));
  }
  ASSERT_EQ(lines.size(), 7u * 4u);
  EXPECT_EQ(lines[1], "rows,1,13,0.3,1,1,");  // theta/beta = 1.03 with five pixels a lens
  EXPECT_EQ(lines[4].substr(0, 10), "views,1,0,");
  EXPECT_EQ(lines[20].substr(0, 17), "combined(2),1,0,0");
  EXPECT_EQ(lines[24].substr(0, 19), "\"strips(2,4)\",1,0,0");
  EXPECT_NE(lines[24].find(",0.3,,"), std::string::npos) << "no equation for fixed strips";
}

TEST(UnitModelTool, ThreadsDoNotMatter) {
  Arguments a = parse_arguments({"Lens_Pixels=5", "Lenses=21", "Rows=40", "A=1:9:1", "D=0:9:1"});
  const shadow::PaperSheet sheet(a.lens, a.lenses, a.rows);
  a.threads = 1;
  const std::string one = csv_of(small_grid(a, sheet, true), a);
  a.threads = 4;
  EXPECT_EQ(one, csv_of(small_grid(a, sheet, true), a));
}

TEST(UnitModelTool, DeviationsAreEquationMinusEnumeration) {
  const Arguments a = parse_arguments({"A=0.05:4:0.5", "D=0:20:4"});
  const shadow::PaperSheet sheet(a.lens, a.lenses, a.rows);
  const Grid grid = small_grid(a, sheet, false);
  const auto all = deviations(grid, a, sheet);
  std::size_t seen = 0;
  for (const Deviation& d : all) {
    if (d.style != "combined" || d.alpha != shadow::paper::Alpha::kRefracted) continue;
    if (d.region != "all" && d.region != "tiny") continue;
    double sum = 0.0, worst = 0.0;
    std::size_t points = 0, equal = 0;
    for (const Point& p : grid.styles[3].points) {
      if (d.region == "tiny" && p.a >= a.lens.pixel_size()) continue;
      const double difference =
          static_cast<double>(*p.refracted) - static_cast<double>(p.enumerated);
      sum += difference;
      if (std::abs(difference) > std::abs(worst)) worst = difference;
      ++points;
      if (difference == 0.0) ++equal;
    }
    EXPECT_EQ(d.points, points);
    EXPECT_EQ(d.equal, equal);
    EXPECT_NEAR(d.mean, sum / static_cast<double>(points), 1e-9);
    EXPECT_EQ(d.worst, worst);
    ++seen;
  }
  EXPECT_EQ(seen, 2u);
}

TEST(UnitModelTool, RegionsHoldWhatTheySay) {
  const camera::LensParameters lens;
  const shadow::PaperSheet sheet(lens, 133);
  const auto alpha = shadow::paper::Alpha::kPrinted;
  const auto region = [&](const char* name, const shadow::ShadowSquare& square) {
    for (std::size_t i = 0; i < regions().size(); ++i) {
      if (regions()[i].name == name) return lies_in(i, sheet, square, alpha);
    }
    ADD_FAILURE() << name;
    return false;
  };
  EXPECT_TRUE(region("near", {20, 0.1, 0.3, 0.3}));
  EXPECT_FALSE(region("near", {20, 1, 0.3, 0.3}));
  EXPECT_TRUE(region("full", {20, 50, 0.3, 0.3}));
  EXPECT_FALSE(region("full", {20, 55, 0.3, 0.3}));
  EXPECT_TRUE(region("small", {1.1, 13, 0.3, 0.3}));
  EXPECT_FALSE(region("small", {1.2, 13, 0.3, 0.3}));
  EXPECT_TRUE(region("tiny", {0.07, 13, 0.3, 0.3}));
  EXPECT_FALSE(region("tiny", {0.08, 13, 0.3, 0.3}));
  EXPECT_TRUE(region("edge", {20, 13, 55, 0.3}));
  EXPECT_TRUE(region("edge", {20, 13, 0.3, 60}));
  EXPECT_FALSE(region("edge", {20, 13, 0.3, 0.3}));
  EXPECT_TRUE(region("elsewhere", {3, 13, 0.3, 0.3}));
  EXPECT_FALSE(region("elsewhere", {20, 13, 0.3, 0.3}));
}

TEST(UnitModelTool, SweepsReachTheCorners) {
  const Arguments a = parse_arguments({"Lenses=41", "Rows=100"});
  const shadow::PaperSheet sheet(a.lens, a.lenses, a.rows);
  EXPECT_LT(sweep("near", a, sheet).x.front(), 0.01);
  EXPECT_LT(sweep("theta", a, sheet).x.front(), 1.0);
  EXPECT_GT(sweep("theta", a, sheet).x.back(), 1.0);
  EXPECT_LT(sweep("small", a, sheet).x.front(), a.lens.pixel_size());
  EXPECT_GT(sweep("small", a, sheet).x.back(), a.lens.pitch);
  // Total reflection begins at P/f = 2/sqrt(n^2 - 1) = 1.60.
  EXPECT_GT(sweep("wide", a, sheet).x.back(), 1.7);
  const Series edges = sweep("edges", a, sheet);
  EXPECT_EQ(edges.points.front()[1].enumerated, 3u);  // left of the sheet, seen by the first lenses
  const std::string csv = csv_of(edges);
  EXPECT_EQ(csv.substr(0, 12), "\"Xstart, mm\"");
}

TEST(UnitModelTool, NumbersAreShort) {
  EXPECT_EQ(tool::number_text(0.1 * 3), "0.3");
  EXPECT_EQ(tool::number_text(40), "40");
  EXPECT_EQ(tool::csv_field("rows"), "rows");
  EXPECT_EQ(tool::csv_field("strips(2,4)"), "\"strips(2,4)\"");
}

}  // namespace
}  // namespace lentray::model
