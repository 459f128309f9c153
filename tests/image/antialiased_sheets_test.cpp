// Antialiased sheets against stock through lentray-diff. Whole N: a sheet is N pictures that stock
// antialiases itself, interlaced. Fractional N: the mean of 8 x 8 mesh_camera samples a pixel.
// Antialias_Angle: the mean of as many finer views.
// Without jitter, for its random numbers differ from stock's; views of at most 128 x 128 pixels.
#include <gtest/gtest.h>

#include <tuple>

#include "tests/support/render.h"

namespace lentray::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using Words = std::vector<std::string>;

struct Scene {
  std::string name, file;
  Words options{};
  friend void PrintTo(const Scene& scene, std::ostream* out) { *out << scene.name; }
};

const std::string kExamples = "/usr/share/doc/povray/examples/";
const Scene kScenes[] = {{"demo", "demo.pov"},
                         {"balls", "spd_balls.pov", {"Declare=Size=2"}},
                         {"woodbox", kExamples + "advanced/woodbox.pov"}};

class AntialiasedSheet : public ::testing::Test {
 protected:
  /// Runs lentray-diff on the scene as an integral image; its JSON lands in m_report.
  tool::RunResult compare(const Scene& scene, const Words& more) {
    Words words{(source_folder() / "scenes" / scene.file).string(), "Lenticular=On",
                // Most of a small picture's time stock waits.
                "--threads", "8", "--json", "report.json", "--output", "p"};
    words.insert(words.end(), scene.options.begin(), scene.options.end());
    words.insert(words.end(), more.begin(), more.end());
    tool::RunResult result = run_diff(words, m_folder.path());
    m_report = fs::exists(m_folder / "report.json")
                   ? json::parse(tool::read_text(m_folder / "report.json"))
                   : json();
    return result;
  }
  void expect(const Scene& scene, const std::string& grade, Words more) {
    if (!fs::exists(source_folder() / "scenes" / scene.file)) {
      GTEST_SKIP() << "povray-examples is not installed";
    }
    more.insert(more.end(), {"--grade", grade, "--no-pictures"});
    const tool::RunResult result = compare(scene, more);
    EXPECT_EQ(result.status, 0) << result.output;
  }

  tool::TemporaryFolder m_folder;
  json m_report;
};

/// Scene, method, viewing distance; no distance: the eye's own.
using Whole = std::tuple<Scene, std::string, std::string>;

std::string name_of_whole(const ::testing::TestParamInfo<Whole>& trial) {
  const auto& [scene, method, distance] = trial.param;
  return scene.name + "_" + method.substr(1) + (distance.empty() ? "_eye" : "_" + distance);
}

class AntialiasedViews : public AntialiasedSheet, public ::testing::WithParamInterface<Whole> {};

TEST_P(AntialiasedViews, AreStocks) {
  const auto& [scene, method, distance] = GetParam();
  Words words{"Lens_Pixels=5", "+W58", "+H60", "+A0.1",
              "+R2",           "-J",   method};  // the last lens is cut
  if (!distance.empty()) words.push_back("View_Distance=" + distance);
  expect(scene, "exact", words);
  EXPECT_EQ(m_report["samples_a_pixel"], 1);
}

INSTANTIATE_TEST_SUITE_P(Scenes, AntialiasedViews,
                         ::testing::Combine(::testing::ValuesIn(kScenes),
                                            ::testing::Values("+AM1", "+AM2"),
                                            ::testing::Values("", "inf")),
                         name_of_whole);

class AntialiasedOf : public AntialiasedSheet, public ::testing::WithParamInterface<Scene> {
 protected:
  // As many samples in ours at the same places, and the centre: more than the close that is promised.
  void expect_mean_of_samples(const char* width, const char* height) {
    expect(GetParam(), "match", {"Lens_Pixels=12.4", width, height, "+A0.0", "+R8", "-J"});
    EXPECT_EQ(m_report["way"], "mesh_camera");
    EXPECT_EQ(m_report["samples_a_pixel"], 64);
  }
};
/// In more pixels.
class SlowAntialiasedOf : public AntialiasedOf {};

TEST_P(AntialiasedOf, FractionalPixelsAreTheMeanOfSamples) {
  expect_mean_of_samples("+W62", "+H36");
}
TEST_P(SlowAntialiasedOf, FractionalPixelsAreTheMeanOfSamples) {
  expect_mean_of_samples("+W99", "+H60");
}

TEST_P(AntialiasedOf, DirectionsAreTheMeanOfFinerViews) {
  expect(GetParam(), "match",
         {"Lens_Pixels=3", "+W30", "+H60", "+A0.0", "-J", "Antialias_Angle=4"});
  EXPECT_EQ(m_report["samples_a_pixel"], 4);
}

INSTANTIATE_TEST_SUITE_P(Scenes, AntialiasedOf, ::testing::ValuesIn(kScenes),
                         [](const auto& trial) { return trial.param.name; });
INSTANTIATE_TEST_SUITE_P(Scenes, SlowAntialiasedOf, ::testing::ValuesIn(kScenes),
                         [](const auto& trial) { return trial.param.name; });

TEST_F(AntialiasedSheet, UsualSettingsAreCloseToTheMeanOfSamples) {
  expect(kScenes[0], "close", {"Lens_Pixels=12.4", "+W62", "+H60", "+A0.0", "-J"});
}

TEST_F(AntialiasedSheet, SnellsLawFromAFiniteDistance) {
  expect(kScenes[0], "match",
         {"Lens_Pixels=5", "Lens_Model=pinhole", "+W50", "+H40", "+A0.0", "+R8", "-J"});
  EXPECT_EQ(m_report["samples_a_pixel"], 64);
}

TEST_F(AntialiasedSheet, DirectionsWithoutAntialiasing) {
  const Words words{"View_Distance=inf", "+W39", "+H40", "Antialias_Angle=3"};
  for (const char* pixels : {"Lens_Pixels=3", "Lens_Pixels=3.9"}) {
    Words more = words;
    more.emplace_back(pixels);
    expect(kScenes[0], "exact", more);
    EXPECT_EQ(m_report["samples_a_pixel"], 3);
  }
}

TEST_F(AntialiasedSheet, AViewAlone) {
  const Words words{"Lens_Pixels=3", "View=2", "+W60", "+H40", "+A0.0", "+AM2", "-J"};
  expect(kScenes[0], "exact", words);
  EXPECT_EQ(m_report["width"], 20);
  Words more = words;
  more.emplace_back("Antialias_Angle=4");
  expect(kScenes[0], "match", more);
}

TEST_F(AntialiasedSheet, IniFilesReachBothRenderers) {
  tool::write_text(m_folder / "fine.ini",
                   "Antialias=On\nAntialias_Threshold=0.05\nJitter=Off\n"
                   "Sampling_Method=2\nAntialias_Depth=2\n");
  expect(kScenes[0], "exact", {(m_folder / "fine.ini").string(), "Lens_Pixels=3", "+W60", "+H40"});
  EXPECT_EQ(m_report["antialiased"], true);
}

/// The working space is not linear light: the mean of samples is taken there.
TEST_F(AntialiasedSheet, MeansAreTakenInTheWorkingSpace) {
  for (const char* settings :
       {"#version 3.7; global_settings { assumed_gamma 2.2 }", "#version 3.5;"}) {
    tool::write_text(m_folder / "scene.pov",
                     std::string(settings) +
                         "\ncamera { location <0,1,-6> look_at 0 right x up y }\n"
                         "light_source { <20,40,-30> rgb 1 }\nbackground { rgb <.1,.2,.4> }\n"
                         "box { <-.97,-1.03,-1>, <1.02,.91,1> rotate <7,31,0>\n"
                         "  pigment { checker rgb 1.8, rgb .03 scale .13 } }\n");
    expect({"own", (m_folder / "scene.pov").string()}, "exact",
           {"Lens_Pixels=3", "+W48", "+H40", "+A0.0", "-J", "Antialias_Angle=4"});
  }
}

TEST_F(AntialiasedSheet, WithoutAntialiasingItDoesNotPass) {
  const Words words{"Lens_Pixels=5", "+W60", "+H60"};
  Words antialiased = words;
  antialiased.insert(antialiased.end(), {"+A0.1", "-J"});
  ASSERT_EQ(compare(kScenes[0], antialiased).status, 0);
  ASSERT_EQ(compare(kScenes[0], words).status, 0);  // p-ours.png is without now
  fs::rename(m_folder / "p-ours.png", m_folder / "bare.png");
  ASSERT_EQ(compare(kScenes[0], antialiased).status, 0);
  const Words pictures{"bare.png", "p-stock.png", "Lens_Pixels=5", "--no-pictures"};
  EXPECT_EQ(run_diff(pictures, m_folder.path()).status, 1);
}

TEST_F(AntialiasedSheet, JitterIsSaidToBeRandom) {
  const tool::RunResult result =
      compare(kScenes[0], {"Lens_Pixels=3", "+W60", "+H60", "+A", "--grade", "close"});
  EXPECT_EQ(result.status, 0) << result.output;
  EXPECT_NE(result.output.find("jitter is on"), std::string::npos) << result.output;
}

/// As many lenses and rows as fill a tile.
class SlowAntialiasedViews : public AntialiasedSheet,
                             public ::testing::WithParamInterface<Whole> {};

TEST_P(SlowAntialiasedViews, AreStocks) {
  const auto& [scene, method, distance] = GetParam();
  Words words{"Lens_Pixels=12", "+W1440", "+H120", "+A0.1", "-J", method};
  if (!distance.empty()) words.push_back("View_Distance=" + distance);
  expect(scene, "exact", words);
}

INSTANTIATE_TEST_SUITE_P(Scenes, SlowAntialiasedViews,
                         ::testing::Combine(::testing::ValuesIn(kScenes),
                                            ::testing::Values("+AM1", "+AM2"),
                                            ::testing::Values("", "inf")),
                         name_of_whole);

}  // namespace
}  // namespace lentray::test
