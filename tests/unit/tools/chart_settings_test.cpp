// lentray-chart: its command line, what it finds out of a scene, which settings follow, and how references converge.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tools/common/duration.h"
#include "tools/common/process.h"
#include "tools/common/shell_words.h"
#include "tools/lentray-chart/arguments.h"
#include "tools/lentray-chart/matrix.h"
#include "tools/lentray-chart/measure.h"
#include "tools/lentray-chart/reference.h"

namespace lentray::chart {
namespace {

class UnitChartArguments : public testing::Test {
 protected:
  UnitChartArguments() { tool::write_text(m_folder / "a.pov", ""); }

  std::string scene() const { return (m_folder / "a.pov").string(); }

  /// What is said about a command line; empty: nothing.
  static std::string refused(const std::vector<std::string>& words) {
    try {
      parse_arguments(words);
    } catch (const parser::OptionError& error) {
      return error.what();
    }
    return "";
  }

  const tool::TemporaryFolder m_folder;
};

TEST_F(UnitChartArguments, OptionsAreItsOwnOrLentrays) {
  const Arguments a =
      parse_arguments({scene(), "--out", "o", "+W320", "--repeats=5", "--budget", "2min",
                       "--error=1.5", "--only", "antialiasing,media,media", "--no-stock", "--quick",
                       "Declare=A=2", "--reference-limit", "500ms", "--povray", "pov", "-V"});
  EXPECT_EQ(a.scene, scene());
  EXPECT_EQ(a.out, "o");
  EXPECT_EQ(a.repeats, 5);
  EXPECT_EQ(a.budget, 120.0);
  EXPECT_EQ(a.error, 1.5);
  EXPECT_EQ(a.only, (std::vector<Kind>{Kind::antialiasing, Kind::media}));
  EXPECT_TRUE(a.quick && !a.with_stock);
  EXPECT_EQ(a.reference_limit, 0.5);
  EXPECT_EQ(a.povray, "pov");
  EXPECT_EQ(a.for_lentray, (std::vector<std::string>{"+W320", "Declare=A=2", "-V", "+WT1"}));
  EXPECT_FALSE(a.options.verbose);
  EXPECT_EQ(a.lentray.filename(), "lentray");
  EXPECT_TRUE(wants(a, Kind::media) && !wants(a, Kind::exact));
}

TEST_F(UnitChartArguments, DefaultsAreThoseOfTheHelp) {
  const Arguments a = parse_arguments({scene(), "--out=o", "+WT2"});
  EXPECT_EQ(a.repeats, 3);
  EXPECT_FALSE(a.budget || a.error || a.quick);
  EXPECT_TRUE(a.with_stock && wants(a, Kind::exact) && a.options.verbose);
  EXPECT_EQ(a.reference_limit, 600.0);
  EXPECT_EQ(a.for_lentray, std::vector<std::string>{"+WT2"});
  EXPECT_EQ(parse_arguments({scene(), "--out=o", "Work_Threads=3"}).for_lentray.size(), 1u);
}

TEST_F(UnitChartArguments, BadOnesAreNamed) {
  const std::string s = scene(), out = "--out=o", ours = "the chart decides that of every picture";
  const std::pair<std::vector<std::string>, std::string> cases[] = {
      {{out}, "no scene given; lentray-chart --help says how"},
      {{s}, "--out DIR is missing"},
      {{"none.pov", out}, "there is no scene 'none.pov'"},
      {{s, s, out}, "two scenes: '"},
      {{s, "--out"}, "--out needs a value"},
      {{s, "--out="}, "the name of a folder is expected"},
      {{s, out, "--colour"}, "unknown option '--colour'; --help lists all"},
      {{s, out, "--repeats", "0"}, "--repeats 0"},
      {{s, out, "--repeats", "some"}, "--repeats some"},
      {{s, out, "--budget", "soon"}, "a time above 0 is expected, such as 30s, 2min or 500ms"},
      {{s, out, "--budget", "-3s"}, "a time above 0 is expected"},
      {{s, out, "--budget", "3days"}, "a time above 0 is expected"},
      {{s, out, "--reference-limit=0"}, "a time above 0 is expected"},
      {{s, out, "--error", "-1"}, "an error in 1/255 is expected, 0 or more"},
      {{s, out, "--error", "inf"}, "--error inf"},
      {{s, out, "--error", "small"}, "--error small"},
      {{s, out, "--only", "colour"}, "'colour' is no kind; there are lens_model, antialiasing"},
      {{s, out, "--only", ""}, "a kind is expected"},
      {{s, out, "--lentray="}, "the name of a program is expected"},
      {{s, out, "--povray="}, "the name of a program is expected"},
      {{s, out, "+Oa.png"}, ours},
      {{s, out, "+Ib.pov"}, ours},
      {{s, out, "+FN8"}, ours},
      {{s, out, "-F"}, ours},
      {{s, out, "+C"}, ours},
      {{s, out, "+GIa.ini"}, ours},
      {{s, out, "Statistics_File=a"}, ours},
      {{s, out, "max_time=3"}, ours},
      {{s, out, "Antialias_Grid=4"}, ours},
      {{s, out, "+KFF3"}, "a chart is of one picture"},
      {{s, out, "Antialias_Dept=3"}, "Antialias_Dept"},
  };
  for (const auto& [words, said] : cases) {
    EXPECT_NE(refused(words).find(said), std::string::npos)
        << words.back() << ": " << said << "\n  not in: " << refused(words);
  }
}

TEST(UnitChartDuration, HasUnits) {
  EXPECT_EQ(tool::duration_of("30s"), 30.0);
  EXPECT_EQ(tool::duration_of("30"), 30.0);
  EXPECT_EQ(tool::duration_of("2min"), 120.0);
  EXPECT_EQ(tool::duration_of("2m"), 120.0);
  EXPECT_EQ(tool::duration_of("500ms"), 0.5);
  EXPECT_EQ(tool::duration_of("1.5h"), 5400.0);
  for (const char* bad : {"", "s", "0s", "-1s", "1 s", "1x", "inf", "nan", "1ss", "1minute"}) {
    EXPECT_FALSE(tool::duration_of(bad)) << bad;
  }
}

TEST(UnitChartShellWords, AreReadBackByAShell) {
  const std::vector<std::string> words{"plain-1.5/x=y", "",      "a b", "it's",
                                       "$HOME",         "\"q\"", "*",   "a\nb"};
  const tool::RunResult said =
      tool::run_program({"sh", "-c", "printf '%s|' " + tool::shell_command(words)});
  std::string expected;
  for (const std::string& word : words) expected += word + "|";
  EXPECT_EQ(said.output, expected);
  EXPECT_EQ(tool::shell_word("+A0.1"), "+A0.1");
}

constexpr const char* kExplanation = R"(Camera
  perspective, 320 x 240 pixels
Scene
  objects               17 after splitting unions
  primitives            1 plane, 16 sphere
  lights                2
Needs
  used                  infinite objects, transparency, reflection, highlights, area lights, fog,
                        media
  not needed            clipping, dispersion, focal blur
  trace level           9 at most (max_trace_level 12)
  radiosity             35 rays a sample, 2 bounces, error_bound 1.8
  photons               spacing 0.02, gather 20 to 100
  subsurface light      50 and 40 samples
Bounding hierarchy
)";

TEST(UnitChartFacts, ComeFromTheExplanation) {
  const SceneFacts f = facts_of(kExplanation);
  EXPECT_TRUE(f.area_lights && f.media && !f.is_sheet && !f.focal_blur);
  EXPECT_EQ(f.objects, 17u);
  EXPECT_EQ(f.depth, 9);
  EXPECT_EQ(f.max_trace_level, 12);
  EXPECT_EQ(f.radiosity_count, 35);
  EXPECT_EQ(f.radiosity_bounces, 2);
  EXPECT_EQ(f.radiosity_error, 1.8);
  EXPECT_EQ(f.photon_gather, 100);
  EXPECT_EQ(f.photon_count, 0);
  EXPECT_EQ(f.subsurface_samples, 50);
  EXPECT_EQ(facts_of("Needs\n  photons  count 20000, gather 10 to 60\n").photon_count, 20000);
  const SceneFacts other = facts_of(
      "Camera\n  lenticular, 60 x 45 pixels\nNeeds\n  used        fog, rainbows or media of the "
      "air\n  not needed  area lights, media\n  trace level 1 at most (max_trace_level 5)\n");
  EXPECT_TRUE(other.is_sheet && !other.area_lights && !other.media);
  EXPECT_EQ(other.depth, 1);
  EXPECT_EQ(facts_of("").depth, 1);
  EXPECT_EQ(facts_of("").radiosity_count, 0);
  EXPECT_EQ(facts_of("").photon_gather, 0);
  EXPECT_EQ(facts_of("").subsurface_samples, 0);
}

TEST(UnitChartFacts, AbilitiesComeFromTheHelp) {
  const Abilities a(
      "  Sampling_Method=1|2|3, +AMn\n      text\n  Lens_Model=paraxial|pinhole\n  Blur_Samples=n");
  EXPECT_TRUE(a.has("sampling_method") && a.has("Blur_Samples") && a.has("Lens_Model"));
  EXPECT_FALSE(a.has("Lens_Rays") || a.has("text"));
  EXPECT_FALSE(Abilities().has("Sampling_Method"));
}

TEST(UnitChartFacts, NoiseIsExplained) {
  EXPECT_EQ(noise_of({}, false), "");
  EXPECT_EQ(noise_of({}, true), "antialiasing is jittered");
  const std::string all = noise_of(facts_of(kExplanation), true);
  EXPECT_NE(all.find("area lights"), std::string::npos);
  EXPECT_NE(all.find("media"), std::string::npos);
  SceneFacts blurred;
  blurred.focal_blur = true;
  EXPECT_NE(noise_of(blurred, false).find("focal blur"), std::string::npos);
}

constexpr const char* kAllOptions =
    "Antialias_Grid=n Specialised_Paths=on|off Area_Light_Adaptive=n|off Area_Light_Samples=n "
    "Blur_Samples=n Media_Method=1|2|3 Media_Samples=n "
    "Radiosity_Count=n Radiosity_Error_Bound=n Radiosity_Nearest_Count=n "
    "Radiosity_Recursion_Limit=n Photon_Count=n Photon_Gather=n Subsurface_Samples=n "
    "Max_Trace_Level=n Adc_Bailout=n Lens_Rays=n Lens_Model=paraxial|pinhole|thick";

MatrixRequest everything() {
  MatrixRequest r;
  r.facts = facts_of(kExplanation);
  r.facts.focal_blur = r.facts.is_sheet = true;
  r.facts.lens_model = "paraxial";
  r.facts.quality_levels = {5, 3};
  r.abilities = Abilities(kAllOptions);
  r.own.threads = 1;
  r.processors = 4;
  return r;
}

std::set<std::string> ids_of(const std::vector<Setting>& settings, std::optional<Kind> kind = {}) {
  std::set<std::string> ids;
  for (const Setting& s : settings) {
    if (!kind || s.kind == *kind) ids.insert(s.id);
  }
  return ids;
}

TEST(UnitChartMatrix, HasEveryKindThatTheSceneUses) {
  const std::vector<Setting> all = settings_of(everything());
  EXPECT_TRUE(all.front().is_plain && all.front().options.empty());
  EXPECT_EQ(ids_of(all).size(), all.size()) << "ids are unique";
  for (const Setting& s : all) {
    EXPECT_EQ(s.id.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-"), std::string::npos)
        << s.id;
    EXPECT_EQ(s.is_plain, &s == &all.front());
    EXPECT_EQ(s.options.empty(), s.is_plain);
    EXPECT_FALSE(s.label.empty());
  }
  const auto has = [&](const char* id) { return ids_of(all).contains(id); };
  for (const char* id : {"lens-paraxial",
                         "lens-pinhole",
                         "lens-thick-4",
                         "lens-thick-64",
                         "aa-method1-depth2-threshold0-1",
                         "aa-method1-depth9-threshold0-1",
                         "aa-method2-depth1-threshold0-1",
                         "aa-method2-depth4-threshold0",
                         "aa-method1-depth3-threshold0-03",
                         "aa-method1-depth3-threshold0-3-jitter",
                         "aa-grid4",
                         "area-samples-4",
                         "area-adaptive-0",
                         "area-adaptive-off",
                         "paths-general",
                         "blur-samples-37",
                         "media-method3-intervals1-samples10",
                         "radiosity-count-400",
                         "radiosity-error-bound-0-25",
                         "radiosity-nearest-count-10",
                         "radiosity-recursion-limit-1",
                         "photons-count-1000000",
                         "photons-gather-200",
                         "subsurface-samples-100",
                         "trace-level-2",
                         "adc-bailout-0-01",
                         "quality-5",
                         "quality-3",
                         "order-columns",
                         "cache-off",
                         "accelerator-grid",
                         "accelerator-list",
                         "light-buffer-off",
                         "band-height-16",
                         "threads-2"}) {
    EXPECT_TRUE(has(id)) << id;
  }
  for (const char* own : {"radiosity-count-35", "photons-gather-100", "subsurface-samples-50"}) {
    EXPECT_FALSE(has(own)) << "the scene's own " << own;
  }
  EXPECT_FALSE(has("aa-off")) << "the user's own";
  EXPECT_FALSE(has("quality-9"));
}

TEST(UnitChartMatrix, LeavesOutWhatTheSceneHasNoUseFor) {
  MatrixRequest r = everything();
  r.facts = SceneFacts{};
  r.facts.objects = 5000;
  const std::vector<Setting> all = settings_of(r);
  for (const Kind kind :
       {Kind::lens_model, Kind::area_light, Kind::focal_blur, Kind::media, Kind::radiosity,
        Kind::photons, Kind::subsurface, Kind::depth, Kind::quality, Kind::combined}) {
    EXPECT_TRUE(ids_of(all, kind).empty()) << name_of(kind);
  }
  EXPECT_FALSE(ids_of(all, Kind::antialiasing).empty());
  EXPECT_FALSE(ids_of(all).contains("accelerator-list")) << "too slow for many objects";
}

TEST(UnitChartMatrix, LeavesOutWhatLentrayHasNot) {
  MatrixRequest r = everything();
  r.abilities = Abilities("Sampling_Method=1|2 Media_Method=1|2|3");
  const std::vector<Setting> all = settings_of(r);
  for (const Setting& s : all) {
    for (const std::string& option : s.options) {
      for (const char* name : {"Area_Light", "Blur", "Max_Trace", "Adc", "Lens_Rays",
                               "Antialias_Grid", "Specialised"}) {
        if (s.kind != Kind::media) {
          EXPECT_FALSE(option.find(name) != std::string::npos) << option;
        }
      }
    }
  }
  EXPECT_EQ(ids_of(all, Kind::lens_model).size(), 2u);
}

TEST(UnitChartMatrix, LeavesOutTheUsersOwn) {
  MatrixRequest r = everything();
  r.own.antialias = true;
  r.own.antialias_threshold = 0.1;
  r.own.antialias_depth = 3;
  r.own.jitter = false;
  r.own.pixel_order = "rows";
  r.own.light_buffer = false;
  const std::set<std::string> ids = ids_of(settings_of(r));
  EXPECT_TRUE(ids.contains("aa-off"));
  EXPECT_FALSE(ids.contains("aa-method1-depth3-threshold0-1"));
  EXPECT_TRUE(ids.contains("aa-method1-depth3-threshold0-1-jitter"));
  EXPECT_FALSE(ids.contains("order-rows"));
  EXPECT_TRUE(ids.contains("order-auto") && ids.contains("light-buffer-on"));
  EXPECT_FALSE(ids.contains("trace-level-12"));
}

TEST(UnitChartMatrix, OnlySomeKindsAndQuick) {
  MatrixRequest r = everything();
  const std::size_t all = settings_of(r).size();
  r.quick = true;
  EXPECT_LT(settings_of(r).size(), all / 2);
  EXPECT_EQ(ids_of(settings_of(r), Kind::exact),
            (std::set<std::string>{"plain", "order-rows", "cache-off", "accelerator-grid",
                                   "light-buffer-off", "paths-general", "threads-2"}));
  r.only = {Kind::media};
  EXPECT_EQ(settings_of(r).size(), 1 + ids_of(settings_of(r), Kind::media).size());
  r.only = {Kind::combined};
  EXPECT_TRUE(ids_of(settings_of(r), Kind::lens_model).empty());
  EXPECT_FALSE(ids_of(settings_of(r), Kind::antialiasing).empty()) << "they are crossed";
}

Point chart_settings_done(const Setting& setting, double seconds, double rms) {
  Point p{setting};
  p.state = State::done;
  p.cpu_s = {seconds};
  p.error.emplace().rms = rms;
  return p;
}

TEST(UnitChartMatrix, CrossesTheFrontsOfTheKinds) {
  const std::vector<Point> points{
      chart_settings_done({"plain", "p", Kind::exact, {}, true}, 1, 9),
      chart_settings_done({"a1", "A1", Kind::antialiasing, {"+R1"}}, 1, 8),
      chart_settings_done({"a2", "A2", Kind::antialiasing, {"+R2"}}, 2, 9),
      chart_settings_done({"a3", "A3", Kind::antialiasing, {"+R3"}}, 3, 2),
      chart_settings_done({"b1", "B1", Kind::area_light, {"S=1"}}, 2, 5),
      Point{{"b2", "B2", Kind::area_light, {"S=2"}}},
      chart_settings_done({"l", "L", Kind::lens_model, {"M=1"}}, 2, 5)};
  const std::vector<Setting> out = combined_settings(points, false);
  ASSERT_EQ(out.size(), 2u);
  EXPECT_EQ(out[0].id, "both-a1-b1");
  EXPECT_EQ(out[0].options, (std::vector<std::string>{"+R1", "S=1"}));
  EXPECT_EQ(out[0].label, "A1; B1");
  EXPECT_EQ(out[0].kind, Kind::combined);
  EXPECT_EQ(out[1].id, "both-a3-b1");
  EXPECT_TRUE(combined_settings({points[0], points[1]}, false).empty());
}

TEST(UnitChartMatrix, CrossesCoarsely) {
  std::vector<Point> points;
  for (const Kind kind : {Kind::antialiasing, Kind::area_light, Kind::media, Kind::depth}) {
    for (int i = 0; i < 9; ++i) {
      const std::string id = std::string(name_of(kind)) + std::to_string(i);
      points.push_back(chart_settings_done({id, id, kind, {id}}, i + 1.0, 9.0 - i));
    }
  }
  const std::vector<Setting> all = combined_settings(points, false);
  EXPECT_EQ(all.size(), 24u);
  EXPECT_EQ(ids_of(all).size(), 24u);
  EXPECT_EQ(combined_settings(points, true).size(), 4u);
}

TEST(UnitChartMatrix, StockHasSomeSettings) {
  for (const Setting& s : settings_of(everything())) {
    const bool expected = s.is_plain || s.kind == Kind::quality ||
                          (s.kind == Kind::antialiasing && s.id.find("grid") == std::string::npos);
    EXPECT_EQ(stock_has(s), expected) << s.id;
  }
}

bool has_option(const ReferenceStep& step, const std::string& option) {
  return std::ranges::find(step.options, option) != step.options.end();
}

TEST(UnitChartReference, RaisesAllThatApplies) {
  MatrixRequest r = everything();
  const auto first = reference_step(r, 0, false), second = reference_step(r, 1, false);
  ASSERT_TRUE(first && second);
  for (const char* option :
       {"Antialias_Grid=3", "Area_Light_Samples=4", "Area_Light_Adaptive=off", "Blur_Samples=64",
        "Media_Method=3", "Media_Samples=20", "Radiosity_Count=200", "Radiosity_Error_Bound=0.25",
        "Radiosity_Recursion_Limit=3", "Photon_Count=200000", "Photon_Gather=200",
        "Subsurface_Samples=100", "Max_Trace_Level=24", "Adc_Bailout=0.001", "+Q9"}) {
    EXPECT_TRUE(has_option(*first, option)) << option;
  }
  for (const char* option :
       {"Antialias_Grid=4", "Area_Light_Samples=6", "Blur_Samples=128", "Media_Samples=28",
        "Radiosity_Count=400", "Radiosity_Recursion_Limit=4", "Photon_Count=400000",
        "Photon_Gather=283", "Subsurface_Samples=141", "Max_Trace_Level=48",
        "Adc_Bailout=0.0005"}) {
    EXPECT_TRUE(has_option(*second, option)) << option;
  }
  EXPECT_TRUE(has_option(*reference_step(r, 4, false), "Antialias_Grid=7"))
      << "blur grows, pixels slowly";
  EXPECT_EQ(first->work, 1.0);
  EXPECT_GT(second->work, 4.0);
  EXPECT_FALSE(has_option(*first, "Lens_Model=thick"));
  EXPECT_TRUE(has_option(*reference_step(r, 0, true), "Lens_Model=thick"));
  EXPECT_TRUE(has_option(*reference_step(r, 1, true), "Lens_Rays=64"));
}

TEST(UnitChartReference, EndsWhereNothingGrows) {
  MatrixRequest r;
  r.abilities = Abilities("Sampling_Method=1|2");
  EXPECT_EQ(reference_step(r, 3, false)->options,
            (std::vector<std::string>{"+A0", "+AM1", "+R9", "-J", "+Q9"}));
  EXPECT_FALSE(reference_step(r, 4, false));
  r.abilities = Abilities("Antialias_Grid=n");
  EXPECT_TRUE(has_option(*reference_step(r, 9, false), "Antialias_Grid=64"));
  EXPECT_FALSE(reference_step(r, 10, false));
  r = everything();
  for (int step = 0; const auto s = reference_step(r, step, true); ++step) {
    ASSERT_LT(step, 20);
    for (const std::string& option : s->options) {
      if (option.starts_with("Max_Trace_Level=")) {
        EXPECT_LE(std::stoi(option.substr(16)), 256);
      }
      if (option.starts_with("Lens_Rays=")) {
        EXPECT_LE(std::stoi(option.substr(10)), 1024);
      }
    }
  }
}

TEST(UnitChartReference, WithoutThickLensesPinholesAreTheTruth) {
  MatrixRequest r = everything();
  r.abilities = Abilities("Lens_Model=paraxial|pinhole");
  EXPECT_TRUE(has_option(*reference_step(r, 0, true), "Lens_Model=pinhole"));
}

TEST(UnitChartReference, IsConvergedForErrorsThatMatter) {
  EXPECT_TRUE(is_converged(0.05, 0.5));
  EXPECT_FALSE(is_converged(0.06, 0.5));
  EXPECT_TRUE(is_converged(0.01, 0.0001)) << "errors below kSmallestError need not be told apart";
  EXPECT_FALSE(is_converged(0.011, 0.0001));
}

TEST(UnitChartMeasure, DearSettingsRunLessOften) {
  EXPECT_EQ(repeats_for(9.9, 5), 5);
  EXPECT_EQ(repeats_for(10.0, 5), 2);
  EXPECT_EQ(repeats_for(10.0, 1), 1);
  EXPECT_EQ(repeats_for(60.0, 5), 1);
}

}  // namespace
}  // namespace lentray::chart
