// lentray-chart: what it keeps to go on, figures of pictures, programs that it runs.
#include <gtest/gtest.h>

#include <signal.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "parser/files/watched_files.h"
#include "tools/common/csv.h"
#include "tools/common/machine.h"
#include "tools/common/process.h"
#include "tools/lentray-chart/compare.h"
#include "tools/lentray-chart/errors.h"
#include "tools/lentray-chart/runner.h"
#include "tools/lentray-chart/state.h"

namespace lentray::chart {
namespace {

namespace fs = std::filesystem;

ChartState full_state() {
  ChartState s;
  s.key = "k";
  s.matrix = "quick media";
  s.seen = {.files = {{"/a.pov", {18446744073709551615u}}}, .missing = {"/b.inc"}};
  s.facts = {320, 240, true, "thick", true, true, true, 40,    2,
             0.5, 80,  9000, 60,      17,   9,    12,   {7, 4}};
  Chart& c = s.chart;
  c.scene = "a b.pov";
  c.command = "lentray 'a b.pov'";
  c.width = 320;
  c.height = 240;
  c.is_sheet = true;
  c.machine = "m";
  c.noise = "n";
  c.reference = {{"+A0"}, "pictures/reference.png",        0.25,
                 3.5,     {{"step", 0.5}, {"next", 0.25}}, true};
  c.lens_reference = Reference{};
  c.stock = "3.7";
  c.stock_reason = "why";
  Point p{{"id", "label \xff", Kind::media, {"a=b", ""}, true}};
  p.state = State::done;
  p.reason = "r";
  p.cpu_s = {0.1, 1e-9};
  p.picture = "p";
  p.difference = "d";
  p.error = Error{1.5, 44.0, 0.25, 9.0, 0.75, 0.6};
  p.from_plain = Error{0.0, std::numeric_limits<double>::infinity(), 0.0, 0.0, {}};
  p.from_stock = Error{1e-4, 120.0, 0.0, 0.5, {}};
  p.stock_runs = {2.0};
  p.stock_error = Error{2.0, 40.0, 0.5, 8.0, {}};
  p.stock_picture = "s";
  c.points = {p, Point{{"q", "Q", Kind::exact, {}}}};
  c.points[1].state = State::failed;
  return s;
}

TEST(UnitChartState, IsReadBackAsItWas) {
  const ChartState s = full_state();
  const ChartState back = state_of(text_of(s));
  EXPECT_EQ(text_of(back), text_of(s));
  EXPECT_EQ(back.seen, s.seen);
  const Point& p = back.chart.points[0];
  EXPECT_EQ(p.cpu_s, s.chart.points[0].cpu_s);
  EXPECT_EQ(p.setting.kind, Kind::media);
  EXPECT_TRUE(p.setting.is_plain && std::isinf(p.from_plain->psnr));
  EXPECT_EQ(p.error->perceived, 0.75);
  EXPECT_FALSE(p.from_plain->perceived);
  EXPECT_EQ(p.error->seen, 0.6);
  EXPECT_FALSE(p.from_plain->seen);
  EXPECT_EQ(p.error->psnr, 44.0);
  EXPECT_EQ(back.chart.points[1].state, State::failed);
  EXPECT_FALSE(back.chart.points[1].error);
  EXPECT_EQ(back.chart.reference.steps, s.chart.reference.steps);
  EXPECT_TRUE(back.chart.reference.is_converged && back.chart.lens_reference);
  EXPECT_EQ(back.facts.quality_levels, s.facts.quality_levels);
  EXPECT_EQ(back.facts.lens_model, "thick");
  EXPECT_EQ(back.facts.radiosity_count, 40);
  EXPECT_EQ(back.facts.radiosity_bounces, 2);
  EXPECT_EQ(back.facts.radiosity_error, 0.5);
  EXPECT_EQ(back.facts.photon_gather, 80);
  EXPECT_EQ(back.facts.photon_count, 9000);
  EXPECT_EQ(back.facts.subsurface_samples, 60);
}

TEST(UnitChartState, DamagedTextIsRefused) {
  const std::string whole = text_of(full_state());
  for (const std::string& bad : {std::string(), std::string("[]"),
                                 whole.substr(0, whole.size() / 2), std::string("{\"key\": 3}")}) {
    EXPECT_THROW(state_of(bad), std::runtime_error);
  }
  std::string kind = whole;
  kind.replace(kind.find("\"media\",\n"), 7, "\"merry\"");
  EXPECT_THROW(state_of(kind), std::runtime_error);
}

std::string said_of_folder(const fs::path& out) {
  try {
    const ChartFolder folder(out);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(UnitChartState, AFolderIsForOneChartAtATime) {
  const tool::TemporaryFolder place;
  const fs::path out = place / "new/out";
  {
    const ChartFolder folder(out);
    EXPECT_FALSE(folder.load());
    folder.save(full_state());
    EXPECT_EQ(text_of(*folder.load()), text_of(full_state()));
    tool::write_text(folder.file("pictures/a.png"), "");
    tool::write_text(folder.file("pictures/mine.txt"), "");
    folder.remove_pictures();
    EXPECT_FALSE(fs::exists(folder.file("pictures/a.png")));
    EXPECT_TRUE(fs::exists(folder.file("pictures/mine.txt")));
    EXPECT_EQ(said_of_folder(out), "another lentray-chart works in '" + out.string() + "'");
    tool::write_text(folder.own("state.json"), "{");
    EXPECT_THROW(folder.load(), std::runtime_error);
  }
  EXPECT_EQ(said_of_folder(out), "");
  tool::write_text(place / "file", "");
  EXPECT_NE(said_of_folder(place / "file").find("cannot write into the folder"), std::string::npos);
}

core::StoredImage flat(float value, int bits = 16) {
  core::StoredImage image;
  image.width = 16;
  image.height = 8;
  image.channels = 3;
  image.bits = bits;
  image.samples.assign(3 * 16 * 8, value);
  return image;
}

TEST(UnitChartErrors, AreIn255thsAtTheBitsOfTheFiles) {
  const core::StoredImage a = flat(0.0f);
  core::StoredImage b = flat(0.0f);
  const Error none = error_of(a, b);
  EXPECT_EQ(none.rms, 0.0);
  EXPECT_TRUE(std::isinf(none.psnr));
  for (int i = 0; i < 3; ++i) b.at(0, 0, i) = 257.0f * 4;  // 4/255 in one pixel of 128
  const Error e = error_of(a, b);
  EXPECT_NEAR(e.rms, 4.0 / std::sqrt(128.0), 1e-9);
  EXPECT_NEAR(e.psnr, 20.0 * std::log10(255.0 / e.rms), 1e-9);
  EXPECT_EQ(e.share, 1.0 / 128.0);
  EXPECT_NEAR(e.largest, 4.0, 1e-9);
  EXPECT_NEAR(error_of(flat(0.0f), flat(1.0f)).rms, 1.0 / 257.0, 1e-9);
  core::StoredImage other = flat(0.0f);
  other.width = 8;
  EXPECT_THROW(error_of(a, other), std::invalid_argument);
  EXPECT_THROW(difference_of(a, other), std::invalid_argument);
}

TEST(UnitChartErrors, DifferencesAreEightfold) {
  const core::StoredImage d = difference_of(flat(257.0f * 10), flat(257.0f * 3));
  EXPECT_EQ(d.bits, 8);
  EXPECT_EQ(d.at(3, 3, 1), 56.0f);
  EXPECT_EQ(difference_of(flat(0.0f), flat(257.0f * 200)).at(0, 0, 0), 255.0f);
}

TEST(UnitChartErrors, ThePerceivedOneIsInWhatButteraugliSays) {
  EXPECT_EQ(perceived_in("18.4675025940\n3-norm: 7.756811\n"), 7.756811);
  EXPECT_FALSE(perceived_in("Usage: butteraugli_main <reference> <distorted>"));
  EXPECT_FALSE(perceived_in("3-norm: nan"));
  EXPECT_FALSE(perceived_in("3-norm: "));
}

TEST(UnitChartErrors, ExactSettingsThatChangeThePictureAreNamed) {
  Chart chart;
  Point p{{"a", "pixel order odd", Kind::exact, {"x"}}};
  p.from_plain.emplace();
  chart.points = {p, p, p, Point{{"b", "b", Kind::exact, {}}}};
  chart.points[1].from_plain->largest = 2.0;
  chart.points[2].from_plain->largest = 2.0;
  chart.points[2].setting.kind = Kind::quality;
  EXPECT_EQ(broken_promises(chart),
            std::vector<std::string>{"pixel order odd changes the picture, by up to 2/255: it must "
                                     "not"});
}

TEST(UnitChartRunner, TellsWhatBecameOfAProgram) {
  const tool::TemporaryFolder folder;
  const Runner runner(folder / "log");
  const Outcome good = runner.run({"sh", "-c", "echo said; echo more >&2"});
  EXPECT_EQ(good.status, 0);
  EXPECT_EQ(good.output, "said\nmore\n");
  EXPECT_FALSE(good.over_limit);
  const Outcome bad = runner.run({"sh", "-c", "echo 'lentray: no scene'; exit 3"});
  EXPECT_EQ(bad.status, 3);
  EXPECT_EQ(reason_of(bad, "x"), "no scene");
  EXPECT_EQ(reason_of(runner.run({"sh", "-c", "exit 3"}), "x"), "exit status 3");
  EXPECT_EQ(reason_of(runner.run({"sh", "-c", "kill -9 $$"}), "x"), "ended by signal 9");
  EXPECT_EQ(reason_of(runner.run({(folder / "none").string()}), "none"),
            "cannot start 'none': is it installed?");
}

TEST(UnitChartRunner, LimitsProcessorTime) {
  const tool::TemporaryFolder folder;
  const Runner runner(folder / "log");
  const Outcome o = runner.run({"sh", "-c", "while :; do :; done"}, 0.5);
  EXPECT_TRUE(o.over_limit);
  EXPECT_GE(o.cpu_s, 0.7) << "limits are whole seconds, rounded up";
  EXPECT_LT(o.cpu_s, 3.0);
  EXPECT_EQ(reason_of(o, "x"), "it took too long");
  EXPECT_FALSE(runner.run({"sh", "-c", "exit 1"}, 5.0).over_limit);
}

TEST(UnitToolsCsv, FieldsAreQuotedWhereTheyMustBe) {
  EXPECT_EQ(tool::csv_field("a b"), "a b");
  EXPECT_EQ(tool::csv_field("a,b"), "\"a,b\"");
  EXPECT_EQ(tool::csv_field("a\"b"), "\"a\"\"b\"");
  EXPECT_EQ(tool::csv_field("a\nb"), "\"a\nb\"");
}

TEST(UnitToolsMachine, NamesItsProcessor) { EXPECT_FALSE(tool::processor_name().empty()); }

}  // namespace
}  // namespace lentray::chart
