// The charts of lentray-chart: of few, equal or perfect settings, stock, lens models, labels.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <random>

#include "tests/unit/tools/chart_samples.h"
#include "tools/lentray-chart/charts.h"
#include "tools/lentray-chart/page_data.h"
#include "tools/lentray-chart/page_labels.h"

namespace lentray::chart {
namespace {

/// Of the circles on top of the symbols, by id.
std::map<std::string, std::pair<double, double>> places(const std::string& svg) {
  std::map<std::string, std::pair<double, double>> out;
  const std::string mark = "data-id=\"";
  for (std::size_t at = svg.find(mark); at != std::string::npos; at = svg.find(mark, at + 1)) {
    const std::size_t from = at + mark.size();
    const auto number = [&](const char* name) {
      return std::atof(svg.c_str() + svg.find(name, from) + std::string(name).size());
    };
    out[svg.substr(from, svg.find('"', from) - from)] = {number("cx=\""), number("cy=\"")};
  }
  return out;
}

/// Where gnuplot put symbols of that point type, to a tenth of a pixel.
bool has_symbol_at(const std::string& svg, const std::pair<double, double>& place) {
  const std::string mark = "transform='translate(";
  for (std::size_t at = svg.find(mark); at != std::string::npos; at = svg.find(mark, at + 1)) {
    double x = 0.0, y = 0.0;
    if (std::sscanf(svg.c_str() + at + mark.size(), "%lf,%lf", &x, &y) != 2) continue;
    if (std::abs(x - place.first) < 0.4 && std::abs(y - place.second) < 0.4) return true;
  }
  return false;
}

TEST(UnitChartCharts, CirclesLieOnSymbols) {
  const Chart chart = sample_chart(
      {plain_point(2.0, 5.0), sample_point("fast", Kind::quality, 0.5, 20.0),
       sample_point("good", Kind::antialiasing, 8.0, 0.7),
       sample_point("worse", Kind::depth, 9.0, 6.0), exact_point("exact-slow", 3.0, 5.0)});
  for (const Window window : {Window::wide, Window::narrow}) {
    const std::string svg = error_chart(chart, Subject::settings, window);
    const auto all = places(svg);
    ASSERT_EQ(all.size(), 4u) << "the exact one, which is slower, is not there";
    for (const auto& [id, place] : all) EXPECT_TRUE(has_symbol_at(svg, place)) << id;
    EXPECT_LT(all.at("fast").first, all.at("plain").first);
    EXPECT_LT(all.at("plain").first, all.at("good").first);
    EXPECT_LT(all.at("fast").second, all.at("plain").second) << "more error is higher";
    EXPECT_LT(all.at("plain").second, all.at("good").second);
    const std::string times = exact_chart(chart, window);
    const auto exact_places = places(times);
    ASSERT_EQ(exact_places.size(), 2u);
    for (const auto& [id, place] : exact_places) EXPECT_TRUE(has_symbol_at(times, place)) << id;
    EXPECT_LT(exact_places.at("plain").first, exact_places.at("exact-slow").first);
    EXPECT_LT(exact_places.at("plain").second, exact_places.at("exact-slow").second);
  }
}

TEST(UnitChartCharts, NothingToDraw) {
  Point failed = sample_point("failed", Kind::quality, 1.0, 1.0), waiting = failed,
        untimed = failed, unknown = failed, odd = failed;
  failed.state = State::failed;
  waiting.state = State::waiting;
  untimed.cpu_s.clear();
  unknown.error.reset();
  odd.error->rms = std::nan("");
  for (const auto& points : {std::vector<Point>{}, {failed, waiting, untimed, unknown, odd}}) {
    Chart chart;
    chart.points = points;
    EXPECT_EQ(error_chart(chart, Subject::settings, Window::wide), "");
    EXPECT_EQ(exact_chart(chart, Window::narrow), "");
    EXPECT_NE(chart_svg(chart).find("No setting has a time and an error yet."), std::string::npos);
  }
}

TEST(UnitChartCharts, OnePoint) {
  const Chart chart = sample_chart({plain_point(1.5, 3.0)});
  const auto all = places(error_chart(chart, Subject::settings, Window::wide));
  ASSERT_EQ(all.size(), 1u);
  EXPECT_GT(all.at("plain").first, 66.0);
  EXPECT_LT(all.at("plain").first, 708.0);
  EXPECT_EQ(exact_chart(chart, Window::wide), "") << "there is nothing to hold it against";
}

TEST(UnitChartCharts, EqualTimesAndErrors) {
  const Chart chart =
      sample_chart({plain_point(1.0, 2.0), sample_point("same", Kind::depth, 1.0, 2.0),
                    sample_point("less", Kind::depth, 1.0, 1.0)});
  const auto all = places(error_chart(chart, Subject::settings, Window::wide));
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(all.at("plain"), all.at("same"));
  EXPECT_EQ(all.at("plain").first, all.at("less").first);
}

TEST(UnitChartCharts, NoErrorStandsAtTheFoot) {
  const Chart chart =
      sample_chart({plain_point(1.0, 2.0), sample_point("perfect", Kind::antialiasing, 4.0, 0.0)});
  const std::string svg = error_chart(chart, Subject::settings, Window::wide);
  const auto all = places(svg);
  EXPECT_TRUE(has_symbol_at(svg, all.at("perfect")));
  EXPECT_GT(all.at("perfect").second, all.at("plain").second + 40.0);
  EXPECT_LT(all.at("perfect").second, 430.0) << "within the axes";
  EXPECT_NE(svg.find("<text>0</text>"), std::string::npos) << "the axis says 0";
  const Chart perfect = sample_chart({plain_point(1.0, 0.0), exact_point("as-good", 2.0, 0.0)});
  EXPECT_EQ(places(error_chart(perfect, Subject::settings, Window::wide)).size(), 1u);
}

TEST(UnitChartCharts, NotToldApartIsHollowInABand) {
  Chart chart =
      sample_chart({plain_point(1.0, 2.0), sample_point("close", Kind::antialiasing, 4.0, 0.05)});
  ASSERT_FALSE(chart.points[1].told_apart);
  const std::string svg = error_chart(chart, Subject::settings, Window::wide);
  EXPECT_NE(svg.find("fill = 'var(--band)'"), std::string::npos);
  EXPECT_NE(svg.find("#errors-wide-gpPt3'"), std::string::npos) << "a hollow square";
  EXPECT_EQ(svg.find("#errors-wide-gpPt4' transform"), std::string::npos) << "a full one";
  chart.reference.change = 0.0;
  EXPECT_EQ(error_chart(chart, Subject::settings, Window::wide).find("var(--band)"),
            std::string::npos);
}

TEST(UnitChartCharts, StockIsASymbolOfItsOwn) {
  Chart chart = sample_chart({plain_point(1.0, 2.0)});
  const std::string star = "#errors-wide-gpPt2' transform";
  EXPECT_EQ(error_chart(chart, Subject::settings, Window::wide).find(star), std::string::npos);
  chart.points[0].stock_cpu_s = 7.0;
  chart.points[0].stock_error = sample_error(2.1);
  EXPECT_NE(error_chart(chart, Subject::settings, Window::wide).find(star), std::string::npos);
}

TEST(UnitChartCharts, LabelsAreShort) {
  const Chart chart = sample_chart(
      {plain_point(8.0, 2.0),
       sample_point("aa-method1-depth3-threshold0-1", Kind::antialiasing, 4.0, 3.0),
       sample_point("depth-2", Kind::depth, 2.0, 5.0),
       sample_point("a-name-that-nobody-would-read-in-a-chart", Kind::media, 1.0, 9.0)});
  const std::string svg = error_chart(chart, Subject::settings, Window::wide);
  for (const char* label : {"plain", "aa-m1-d3-t0-1", "depth-2", "a-name-that-nobody-wou.."}) {
    EXPECT_NE(svg.find("<text>" + std::string(label) + "</text>"), std::string::npos) << label;
  }
}

TEST(UnitChartCharts, LensModelsHaveAChartOfTheirOwn) {
  Chart chart =
      sample_chart({plain_point(1.0, 2.0), sample_point("thin", Kind::lens_model, 2.0, 3.0)});
  EXPECT_EQ(places(error_chart(chart, Subject::settings, Window::wide)).size(), 2u);
  EXPECT_EQ(error_chart(chart, Subject::lens_models, Window::wide), "");
  chart.lens_reference = Reference{};
  EXPECT_EQ(places(error_chart(chart, Subject::settings, Window::wide)).count("thin"), 0u);
  EXPECT_EQ(places(error_chart(chart, Subject::lens_models, Window::wide)).count("thin"), 1u);
  EXPECT_TRUE(can_be_chosen(chart.points[0]));
  EXPECT_FALSE(can_be_chosen(chart.points[1]));
}

TEST(UnitChartCharts, Files) {
  Chart chart =
      sample_chart({plain_point(2.0, 5.0), sample_point("good", Kind::antialiasing, 8.0, 0.7),
                    exact_point("list", 3.0, 5.0)});
  chart.scene = "it's 100% <odd>\n.pov";
  EXPECT_EQ(chart_png(chart).substr(1, 3), "PNG");
  const std::string svg = chart_svg(chart);
  EXPECT_NE(svg.find("it's 100% &lt;odd> .pov"), std::string::npos);
  EXPECT_EQ(svg.find("POV-Ray"), std::string::npos) << "no stock, no word of it";
  EXPECT_NE(svg.find("list in words"), std::string::npos);
}

TEST(UnitChartLabels, AreClearOfPointsAndEachOther) {
  std::vector<LabelWish> wishes;
  std::vector<Spot> spots;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> x(0, 800), y(0, 500);
  for (int i = 0; i < 40; ++i) {
    spots.push_back({x(random), y(random)});
    wishes.push_back({spots.back(), "setting-" + std::to_string(i), i == 39});
  }
  const auto placed = placed_labels(wishes, spots, {0, 0, 800, 500}, 12);
  ASSERT_EQ(placed.size(), 12u);
  EXPECT_EQ(placed[0].text, "setting-39") << "it comes first";
  for (const PlacedLabel& a : placed) {
    const double right = a.left + label_width(a.text);
    EXPECT_GE(a.left, 0.0);
    EXPECT_LE(right, 800.0);
    for (const Spot& s : spots) {
      EXPECT_FALSE(s.x > a.left && s.x < right && std::abs(s.y - a.middle) < kLabelHeight / 2);
    }
    for (const PlacedLabel& b : placed) {
      if (&a == &b) continue;
      EXPECT_FALSE(a.left < b.left + label_width(b.text) && b.left < right &&
                   std::abs(a.middle - b.middle) < kLabelHeight - 0.01)
          << a.text << ' ' << b.text;
    }
  }
  EXPECT_TRUE(
      placed_labels({{{5, 5}, "far too long for this", false}}, {}, {0, 0, 50, 20}, 9).empty());
}

}  // namespace
}  // namespace lentray::chart
