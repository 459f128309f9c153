// Views of sheets of scenes with radiosity, which share one pass, beside stock's own pictures of them: each within the
// noise of stock's picture of that view (core/image/compare.h). Slow: stock renders each view four times. Each
// test prints a row of the table in docs/global.md.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "tests/support/render.h"

namespace lentray::test {
namespace {

namespace fs = std::filesystem;

constexpr int kSheetViews = 15;

struct RadiositySheet {
  fs::path scene;
  tool::TemporaryFolder folder{};

  std::string view(int j) const { return "view" + std::to_string(j); }

  /// All views in one run, and stock's scene of each.
  void render() const {
    const std::vector<std::string> sheet{"Lenticular=On", "+W480", "+H360", "-A"};
    std::vector<std::string> wrappers{scene.string(), "--write-wrappers", folder.path().string()};
    wrappers.insert(wrappers.end(), sheet.begin(), sheet.end());
    const tool::RunResult written = run_diff(wrappers, folder.path());
    ASSERT_EQ(written.status, 0) << written.output;
    std::vector<std::string> views{"+I" + scene.string(),
                                   "+O" + (folder / "ours.png").string(),
                                   "Views=15",
                                   "View_Size=160x120",
                                   "-D",
                                   "-V",
                                   "Scene_Writes=memory"};
    views.insert(views.end(), sheet.begin(), sheet.end());
    const tool::RunResult made = run_lentray(views, scene.parent_path(), 1200.0);
    ASSERT_EQ(made.status, 0) << made.output;
  }

  StoredImage ours(int j) const {
    return core::read_image(folder / ((j < 10 ? "ours0" : "ours") + std::to_string(j) + ".png"));
  }

  StoredImage stock(int j, const char* block, const char* threads) const {
    const tool::RunResult run =
        tool::run_program({"povray", "+I" + view(j) + ".pov", "+Ostock.png", "+W160", "+H120", "-A",
                           "-J", "-D", "-V", "+L" + scene.parent_path().string(), block, threads},
                          folder.path(), 600.0);
    EXPECT_EQ(run.status, 0) << run.output;
    return core::read_image(folder / "stock.png");
  }

  Comparison compared(int j) const {
    const StoredImage reference = stock(j, "+BS32", "+WT1");
    const std::vector<StoredImage> others{stock(j, "+BS8", "+WT1"), stock(j, "+BS256", "+WT1"),
                                          stock(j, "+BS32", "+WT2")};
    core::LensComparison result;
    const StoredImage picture = ours(j);
    result.whole = core::compare(picture, reference, core::Columns::all(picture.width));
    core::grade_by_noise(result, reference, others);
    return result.whole;
  }
};

using GoodView = bool (*)(const Comparison&);

/// How many views are good; prints the worst figures of all.
void radiosity_sheet_check(const char* name, GoodView is_good) {
  const RadiositySheet sheet{fs::path("/usr/share/doc/povray/examples") / name};
  if (!fs::exists(sheet.scene)) GTEST_SKIP() << "povray-examples is not installed";
  ASSERT_NO_FATAL_FAILURE(sheet.render());
  core::BlockDifference most, noise;
  int within = 0;
  for (int j = 0; j < kSheetViews; ++j) {
    const Comparison c = sheet.compared(j);
    EXPECT_TRUE(is_good(c)) << "view " << j << ": blocks " << c.blocks.rms << ", S " << c.noise->rms
                            << "; bias " << c.blocks.bias << ", S " << c.noise->bias;
    if (c.grade >= Grade::noise) ++within;
    most.rms = std::max(most.rms, c.blocks.rms);
    most.bias = std::max(most.bias, std::abs(c.blocks.bias));
    noise.rms = std::max(noise.rms, c.noise->rms);
    noise.bias = std::max(noise.bias, c.noise->bias);
  }
  std::printf("| %s | %d of %d | %.2f, %.2f | %.2f, %.2f |\n", name, within, kSheetViews, most.rms,
              noise.rms, most.bias, noise.bias);
}

TEST(SlowRadiositySheets, EveryViewIsWithinStocksNoise) {
  radiosity_sheet_check("advanced/object_pattern.pov",
                        [](const Comparison& c) { return c.grade >= Grade::noise; });
}

/// Of coarse settings the mean of all views may be farther off than stock's noise: their one pass is off alike in
/// each. The means of blocks are not. They are in radiosity/rad_def_test_37, whose pass has some 200 samples: of it
/// 6 of 15 views are within both limits (docs/global.md).
class SlowRadiositySheetsBlocks : public ::testing::TestWithParam<const char*> {};

TEST_P(SlowRadiositySheetsBlocks, AreWithinStocksNoise) {
  radiosity_sheet_check(GetParam(), [](const Comparison& c) {
    return c.grade >= Grade::noise || core::is_within({c.blocks.rms, 0.0}, *c.noise);
  });
}

INSTANTIATE_TEST_SUITE_P(Debian, SlowRadiositySheetsBlocks,
                         ::testing::Values("radiosity/radiosity2.pov", "radiosity/radiosity3.pov",
                                           "radiosity/radiosity_37.pov"),
                         [](const auto& scene) { return fs::path(scene.param).stem().string(); });

}  // namespace
}  // namespace lentray::test
