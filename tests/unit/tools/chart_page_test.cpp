// The page of lentray-chart: every state of a setting, escaping, size, missing pictures.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>

#include "core/image/reader.h"
#include "tests/unit/tools/chart_samples.h"
#include "tools/common/inline_svg.h"
#include "tools/common/page_text.h"
#include "tools/common/process.h"
#include "tools/lentray-chart/charts.h"
#include "tools/lentray-chart/page.h"
#include "tools/lentray-chart/page_data.h"
#include "tools/lentray-chart/page_sections.h"

namespace lentray::chart {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

std::size_t count_of(const std::string& text, const std::string& what) {
  std::size_t count = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1))
    ++count;
  return count;
}

// --- what pages share

TEST(UnitInlineSvg, HasNamesAndColoursOfThePage) {
  const std::string svg =
      "<?xml version=\"1.0\"?><svg \n width=\"6\" height=\"4\"\n viewBox=\"0 0 6 4\"\n>"
      "<title>Gnuplot</title><desc>x</desc><rect x=\"0\" y=\"0\" width=\"6\" fill=\"#ffffff\"/>"
      "<circle id='gpPt5'/><use xlink:href='#gpPt5' color='rgb(  1,   2,   3)'/>"
      "<g id=\"gnuplot_plot_2\" ><title>a</title></g><g color=\"black\" "
      "fill=\"rgb(1,2,3)\"></g></svg>";
  EXPECT_EQ(tool::inline_svg(svg, {"n", "a \"b\"", {{0x010203, "red"}}, "<i/>"}),
            "<svg class=\"chart\" viewBox=\"0 0 6 4\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" "
            "role=\"group\" aria-label=\"a &quot;b&quot;\">\n"
            "<circle id='n-gpPt5'/><use xlink:href='#n-gpPt5' color='red'/>"
            "<g id=\"n-series-1\" ></g><g  fill=\"red\"></g><i/></svg>\n");
  EXPECT_EQ(tool::inline_svg("no picture", {"n", "a"}), "");
}

TEST(UnitPageText, FramesAndCuts) {
  EXPECT_EQ(tool::filled("a{{x}}b{{y}}c", {{"x", "{{y}}"}, {"y", "2"}}), "a{{y}}b2c");
  EXPECT_EQ(tool::cut_text("abcdef", 3), "abc…");
  EXPECT_EQ(tool::cut_text("a\xc3\xbc", 2), "a…");
  EXPECT_EQ(tool::cut_text("abc", 3), "abc");
}

// --- sections

TEST(UnitChartPage, VerdictsOfEveryState) {
  Chart chart = sample_chart({plain_point(2.0, 5.0), sample_point("better", Kind::depth, 1.0, 4.0),
                              exact_point("list", 3.0, 5.0),
                              sample_point("close", Kind::antialiasing, 9.0, 0.05)});
  const auto verdict_of = [&](std::size_t i) { return verdict(chart, chart.points[i]); };
  EXPECT_EQ(verdict_of(0), "better in words is better");
  EXPECT_EQ(verdict_of(1), "on the front");
  EXPECT_EQ(verdict_of(2), "same picture");
  EXPECT_EQ(verdict_of(3), "on the front; error not distinguished");
  chart.points[2].from_plain = sample_error(1.0);
  EXPECT_EQ(verdict_of(2), "NOT the plain picture");
  chart.points[0].dominated_by = "gone";
  EXPECT_EQ(verdict_of(0), "gone is better");
  chart.points[0].dominated_by.clear();
  EXPECT_EQ(verdict_of(0), "another is as good");
  chart.points[0].error.reset();
  EXPECT_EQ(verdict_of(0), "no error is known");
  chart.points[0].state = State::failed;
  chart.points[0].reason = "no memory";
  EXPECT_EQ(verdict_of(0), "failed: no memory");
  chart.points[0].state = State::waiting;
  EXPECT_EQ(verdict_of(0), "waiting");
}

TEST(UnitChartPage, StatusAndFilters) {
  Chart chart =
      sample_chart({plain_point(2.0, 5.0), sample_point("a", Kind::area_light, 1.0, 4.0)});
  EXPECT_EQ(status_line(chart, true), "2 of 2 settings are measured.");
  chart.points[1].state = State::failed;
  EXPECT_EQ(status_line(chart, false), "1 of 2 settings are measured, 1 failed. Still running.");
  const std::string buttons = filters(chart);
  for (const char* key : {"all", "front", "area_light", "exact", "failed"}) {
    EXPECT_NE(buttons.find("data-key=\"" + std::string(key) + "\""), std::string::npos) << key;
  }
  EXPECT_EQ(buttons.find("data-key=\"media\""), std::string::npos) << "there is none";
  EXPECT_EQ(status_line(Chart{}, true), "0 of 0 settings are measured.");
}

TEST(UnitChartPage, RowsSortByWhatTheyMean) {
  Chart chart = sample_chart({plain_point(2.0, 0.0)});
  chart.points[0].stock_cpu_s = 14.0;
  chart.points[0].error->perceived = 0.25;
  chart.points[0].error->seen = 0.625;
  const std::string row = table_rows(chart);
  for (const char* cell :
       {"data-value=\"2\"", "data-value=\"inf\">equal", "data-value=\"14\">14.00 s",
        "data-value=\"0.25\">0.250", "data-value=\"0.625\">0.625", "title=\"1.80 s to 2.40 s\"",
        "<td data-value=\"\"></td>"}) {
    EXPECT_NE(row.find(cell), std::string::npos) << cell << " in " << row;
  }
}

TEST(UnitChartPage, ReferencesTellHowFarTheyAre) {
  Reference reference;
  reference.change = 0.0312;
  reference.cpu_s = 61.0;
  reference.steps = {{"<4> samples", 0.5}};
  const std::string text = reference_text(reference, "gone & lost");
  for (const char* part : {"It is not converged.", "0.0312 / 255", "Errors from 0.312 on",
                           "61.00 s", "&lt;4&gt; samples", "No picture of it: gone &amp; lost"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part << " in " << text;
  }
  reference.is_converged = true;
  EXPECT_EQ(reference_text(reference, "").find("not converged"), std::string::npos);
}

// --- the page

class UnitChartPageOf : public ::testing::Test {
 protected:
  PageOptions options() const { return {m_folder / ".", 20'000'000, true}; }
  static json data_of(const std::string& text) {
    const std::string begin = "<script type=\"application/json\" id=\"data\">";
    const std::size_t from = text.find(begin) + begin.size();
    return json::parse(text.substr(from, text.find("</script>", from) - from));
  }
  template <typename Shade>
  void write(const std::string& file, std::uint32_t width, std::uint32_t height,
             const Shade& shade) const {
    core::StoredImage image;
    image.width = width;
    image.height = height;
    image.channels = 3;
    image.bits = 16;
    std::vector<std::uint16_t> samples;
    for (std::uint32_t y = 0; y < height; ++y) {
      for (std::uint32_t x = 0; x < width; ++x) {
        for (int c = 0; c < 3; ++c) {
          samples.push_back(
              static_cast<std::uint16_t>(65535.0 * std::clamp(shade(x, y, c), 0.0, 1.0)));
        }
      }
    }
    image.samples.store<std::uint16_t>(std::move(samples));
    fs::create_directories((m_folder / file).parent_path());
    core::write_stored(image, m_folder / file);
  }
  void write_noise(const std::string& file, std::uint32_t width, std::uint32_t height,
                   unsigned seed) const {
    std::mt19937 random(seed);
    write(file, width, height,
          [&](auto, auto, auto) { return static_cast<double>(random() % 256) / 255.0; });
  }
  const tool::TemporaryFolder m_folder;
};

TEST_F(UnitChartPageOf, EmptyChart) {
  Chart chart;
  const std::string text = page(chart, options());
  EXPECT_NE(text.find("No setting has a time and an error yet."), std::string::npos);
  EXPECT_NE(text.find("</html>"), std::string::npos);
  EXPECT_TRUE(data_of(text)["points"].empty());
}

TEST_F(UnitChartPageOf, StrangersTextStaysText) {
  const std::string bad = "</script><script>alert(1)</script> \"ü\" & \x01 \xff '";
  Chart chart = sample_chart({plain_point(1.0, 2.0), sample_point("a", Kind::depth, 2.0, 1.0),
                              sample_point("b", Kind::depth, 3.0, 1.0)});
  chart.scene = chart.command = chart.machine = chart.noise = chart.stock_reason = bad;
  for (Point& p : chart.points)
    p.setting.label = p.command = p.reason = p.picture = p.stock_picture = bad;
  chart.points[2].state = State::failed;
  chart.points[1].setting.options = {bad};
  chart.reference.options = {bad};
  chart.reference.picture = bad;
  chart.reference.steps = {{bad, 1.0}};
  const std::string text = page(chart, options());
  EXPECT_EQ(text.find("<script>alert"), std::string::npos);
  EXPECT_EQ(count_of(text, "</script>"), 2u) << "the data's and the program's";
  EXPECT_EQ(count_of(text, "<!--"), 0u);
  EXPECT_EQ(text.find('\xff'), std::string::npos);
  EXPECT_EQ(text.find('\x01'), std::string::npos);
  const json data = data_of(text);
  EXPECT_EQ(data["points"][1]["options"][0],
            "</script><script>alert(1)</script> \"ü\" & \x01 \xEE\xBF\xBF '");
}

TEST_F(UnitChartPageOf, NotesSayWhatIsAmiss) {
  Chart chart = sample_chart({plain_point(1.0, 2.0)});
  EXPECT_EQ(page(chart, options()).find("class=\"is-warning note\""), std::string::npos);
  chart.reference.is_converged = false;
  chart.stock_reason = "it is not installed";
  chart.noise = "jitter";
  const std::string text = page(chart, options());
  for (const char* words :
       {"The reference is not converged;", "Nothing of POV-Ray: it is not installed",
        "The pictures have random noise: jitter"}) {
    EXPECT_NE(text.find(words), std::string::npos) << words;
  }
}

TEST_F(UnitChartPageOf, WithoutGnuplotThereIsTheRest) {
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", m_folder.path().c_str(), 1);
  const std::string text = page(sample_chart({plain_point(1.0, 2.0)}), options());
  ::setenv("PATH", path.c_str(), 1);
  EXPECT_NE(text.find("No chart: cannot start 'gnuplot'"), std::string::npos);
  EXPECT_NE(text.find("data-go=\"plain\""), std::string::npos);
}

TEST_F(UnitChartPageOf, LoadsNothingFromElsewhere) {
  const std::string text = page(sample_chart({plain_point(1.0, 2.0)}), options());
  EXPECT_NE(text.find("default-src 'none'"), std::string::npos);
  for (const char* what : {"src=\"http", "href=\"http", "@import", "url("}) {
    EXPECT_EQ(text.find(what), std::string::npos) << what;
  }
}

TEST_F(UnitChartPageOf, EveryStateOfASetting) {
  Chart chart = sample_chart({plain_point(1.0, 2.0), sample_point("fails", Kind::quality, 1.0, 1.0),
                              sample_point("waits", Kind::quality, 1.0, 1.0),
                              sample_point("perfect", Kind::depth, 3.0, 0.0)});
  chart.points[1].state = State::failed;
  chart.points[1].reason = "it said no";
  chart.points[2].state = State::waiting;
  PageOptions running = options();
  running.is_finished = false;
  const std::string text = page(chart, running);
  EXPECT_NE(text.find("Still running."), std::string::npos);
  EXPECT_NE(text.find("id=\"again\""), std::string::npos);
  const json points = data_of(text)["points"];
  EXPECT_EQ(points[0]["state"], "done");
  EXPECT_EQ(points[1]["reason"], "it said no");
  EXPECT_FALSE(points[1].contains("seconds"));
  EXPECT_EQ(points[2]["state"], "waiting");
  EXPECT_FALSE(points[3]["error"].contains("psnr")) << "JSON has no infinity";
  EXPECT_EQ(points[3]["error"]["rms"], 0.0);
  EXPECT_TRUE(points[3]["front"]);
  EXPECT_TRUE(points[3]["blurred"]) << "0 is below what is told apart";
  EXPECT_EQ(points[0]["problem"], "No picture was kept.");
  EXPECT_EQ(page(chart, options()).find("id=\"again\""), std::string::npos);
}

TEST_F(UnitChartPageOf, PicturesAreThereOnceAndMissingOnesAreTold) {
  Chart chart = sample_chart({plain_point(1.0, 2.0), exact_point("list", 2.0, 2.0),
                              sample_point("lost", Kind::depth, 3.0, 1.0)});
  write_noise("pictures/plain.png", 64, 48, 1);
  write_noise("pictures/list.png", 64, 48, 2);
  write_noise("pictures/reference.png", 64, 48, 3);
  chart.points[0].picture = "pictures/plain.png";
  chart.points[1].picture = "pictures/list.png";
  chart.points[2].picture = "pictures/lost.png";
  chart.reference.picture = "pictures/reference.png";
  const std::string text = page(chart, options());
  const json data = data_of(text);
  EXPECT_EQ(data["pictures"].size(), 2u) << "an exact setting has the plain picture";
  EXPECT_EQ(data["points"][1]["picture"], data["points"][0]["picture"]);
  EXPECT_EQ(data["points"][1]["picture_href"], "./pictures/list.png");
  EXPECT_FALSE(data["points"][2].contains("picture"));
  EXPECT_NE(data["points"][2]["problem"].get<std::string>().find("lost.png"), std::string::npos);
  EXPECT_EQ(data["reference"], 1);
  // Another page takes them from the folder.
  EXPECT_TRUE(fs::exists(m_folder / ".lentray-chart/thumbnails"));
  EXPECT_EQ(page(chart, options()), text);
}

TEST_F(UnitChartPageOf, StaysBelowItsSize) {
  std::vector<Point> points{plain_point(1.0, 2.0)};
  for (int i = 0; i < 40; ++i) {
    points.push_back(
        sample_point("s" + std::to_string(i), Kind::antialiasing, 1.0 + i, 2.0 / (1 + i)));
  }
  Chart chart = sample_chart(std::move(points));
  chart.width = 320;
  chart.height = 240;
  unsigned seed = 0;
  for (Point& p : chart.points) {
    p.picture = "pictures/" + p.setting.id + ".png";
    p.difference = "pictures/" + p.setting.id + "-difference.png";
    write_noise(p.picture, 320, 240, ++seed);
    write_noise(p.difference, 320, 240, ++seed);
  }
  PageOptions small = options();
  small.most_bytes = 1;
  const std::size_t frame = page(chart, small).size();
  std::size_t last = 100'000'000;
  for (const std::size_t most : {std::size_t{4'000'000}, std::size_t{1'000'000}, frame + 1000}) {
    small.most_bytes = most;
    const std::string text = page(chart, small);
    EXPECT_LE(text.size(), most);
    EXPECT_LT(text.size(), last);
    last = text.size();
    const bool is_full = most == frame + 1000;
    EXPECT_EQ(data_of(text)["pictures"].size(), is_full ? 0u : 82u) << most;
    EXPECT_EQ(text.find("The page has no room for pictures.") != std::string::npos, is_full);
  }
}

// --- for tests/chart/page_in_browser.py, which looks at it in a browser

class UnitChartPageForBrowser : public UnitChartPageOf {
 protected:
  /// A disc and stripes, sampled `samples` times in each direction.
  double shade(double x, double y) const {
    const double r = std::hypot(x - 160, y - 120);
    if (r < 80) return 0.85;
    return std::fmod(0.35 * x + 0.8 * y + 1000, 12) < 3 ? 0.2 : 0.5;
  }
  double sampled(std::uint32_t x, std::uint32_t y, int samples) const {
    double sum = 0.0;
    for (int i = 0; i < samples * samples; ++i) {
      sum += shade(x + (i % samples + 0.5) / samples, y + (i / samples + 0.5) / samples);
    }
    return sum / (samples * samples);
  }
  Point shown(Point p, int samples, double shadow = 0.0) const {
    p.picture = "pictures/" + p.setting.id + ".png";
    p.difference = "pictures/" + p.setting.id + "-difference.png";
    std::vector<double> own, errors;
    for (std::uint32_t y = 0; y < 240; ++y) {
      for (std::uint32_t x = 0; x < 320; ++x) {
        own.push_back(sampled(x, y, samples) - (x > 240 ? shadow : 0.0));
        errors.push_back(8 * std::abs(own.back() - m_reference[own.size() - 1]));
      }
    }
    write(p.picture, own);
    write(p.difference, errors);
    return p;
  }
  void write(const std::string& file, const std::vector<double>& greys) const {
    UnitChartPageOf::write(file, 320, 240, [&](std::uint32_t x, std::uint32_t y, int c) {
      return greys[y * 320 + x] * (c == 2 ? 1.0 : 0.8);
    });
  }
  void SetUp() override {
    for (std::uint32_t y = 0; y < 240; ++y) {
      for (std::uint32_t x = 0; x < 320; ++x) m_reference.push_back(sampled(x, y, 8));
    }
  }
  std::vector<double> m_reference{};
};

TEST_F(UnitChartPageForBrowser, Write) {
  std::vector<Point> points;
  Point own = plain_point(2.1, 4.2);
  own.setting.options = {""};
  points.push_back(shown(own, 1));
  points[0].stock_runs = {14.0};
  points[0].stock_error = sample_error(4.3);
  points[0].from_stock = sample_error(0.4);
  points[0].stock_picture = points[0].picture;
  const auto add = [&](const char* id, const char* label, Kind kind, double seconds, double rms,
                       int samples, double shadow = 0.0) {
    Point p = sample_point(id, kind, seconds, rms);
    p.setting.label = label;
    points.push_back(shown(p, samples, shadow));
    points.back().from_plain = sample_error(4.0);
    points.back().error->perceived = rms / 3;
  };
  add("aa-1-2", "antialiasing, method 1, 2 x 2 samples", Kind::antialiasing, 4.6, 2.0, 2);
  add("aa-1-3", "antialiasing, method 1, 3 x 3 samples", Kind::antialiasing, 8.3, 1.1, 3);
  add("aa-1-5", "antialiasing, method 1, 5 x 5 samples", Kind::antialiasing, 20.0, 0.5, 5);
  add("aa-1-9", "antialiasing, method 1, 9 x 9 samples", Kind::antialiasing, 61.0, 0.06, 9);
  add("aa-2-1", "antialiasing, method 2, depth 1", Kind::antialiasing, 3.4, 2.6, 2);
  add("aa-2-2", "antialiasing, method 2, depth 2", Kind::antialiasing, 5.2, 1.4, 3);
  add("aa-2-3", "antialiasing, method 2, depth 3", Kind::antialiasing, 9.9, 0.9, 4);
  add("quality-1", "quality 1: no shadows", Kind::quality, 0.4, 31.0, 1, 0.2);
  add("quality-4", "quality 4: shadows, no area lights", Kind::quality, 1.2, 12.0, 1, 0.1);
  add("depth-2", "2 bounces", Kind::depth, 1.7, 6.3, 1, 0.05);
  add("depth-40", "40 bounces", Kind::depth, 2.5, 4.1, 1, 0.01);
  add("area-1", "area lights of 1 sample", Kind::area_light, 1.5, 9.1, 1, 0.08);
  add("area-16", "area lights of 16 samples", Kind::area_light, 3.9, 4.0, 1);
  add("blur-4", "focal blur of 4 samples", Kind::focal_blur, 1.6, 8.0, 1, 0.03);
  add("media-2", "media, 2 samples", Kind::media, 1.9, 5.5, 1, 0.02);
  add("combined-1", "method 2, depth 2, and area lights of 1 sample", Kind::combined, 3.1, 2.4, 3,
      0.01);
  const std::pair<const char*, double> times[] = {{"accelerator grid", 2.6},
                                                  {"accelerator list", 9.0},
                                                  {"without light buffers", 2.4},
                                                  {"shadow cache off", 2.3},
                                                  {"pixel order columns", 2.0}};
  for (const auto& [label, seconds] : times) {
    Point p = exact_point("exact-" + std::to_string(points.size()), seconds, 4.2);
    p.setting.label = label;
    p.picture = points[0].picture;
    p.difference = points[0].difference;
    points.push_back(p);
  }
  points.back().from_plain = sample_error(0.5);
  Point failed = sample_point("failed", Kind::media, 1.0, 1.0);
  failed.setting.label = "<img src=x onerror=\"window.harm=1\">";
  failed.state = State::failed;
  failed.reason = "<script>window.harm=2</script> is no option " + std::string(300, 'w');
  points.push_back(failed);
  Point lost = sample_point("lost", Kind::depth, 3.0, 3.9);
  lost.setting.label = "a picture that is not there";
  lost.picture = "pictures/lost.png";
  points.push_back(lost);
  Chart chart = sample_chart(std::move(points));
  chart.scene = "a <scene>.pov";
  chart.command = "lentray 'a scene.pov' +W320 +H240";
  derive(chart);
  chart.width = 320;
  chart.height = 240;
  chart.machine = "a processor, 1 thread";
  chart.noise = "the scene has jitter";
  chart.reference.cpu_s = 300.0;
  chart.reference.picture = "pictures/reference.png";
  write(chart.reference.picture, m_reference);
  const std::string text = page(chart, options());
  EXPECT_LT(text.size(), 20'000'000u);
  tool::write_text(m_folder / "index.html", text);
  tool::write_text(m_folder / "chart.svg", chart_svg(chart));
  tool::write_text(m_folder / "chart.png", chart_png(chart));
  if (const char* const to = std::getenv("LENTRAY_PAGE_FOLDER")) {
    fs::copy(m_folder / ".", to,
             fs::copy_options::recursive | fs::copy_options::overwrite_existing);
  }
}

}  // namespace
}  // namespace lentray::chart
