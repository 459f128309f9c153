// The factor that a Depth_Budget asks for, where a sheet would stand best, and the report of --depth.
#include "camera/depth_budget.h"

#include <gtest/gtest.h>

#include <cmath>

#include "camera/depth_report.h"
#include "camera/depth_survey.h"
#include "camera/parallax.h"
#include "tests/unit/camera/depth_scene.h"

namespace lentray::camera {
namespace {

TEST(UnitCameraDepthBudget, ABudgetIsKeptAndTheFactorIsNoSmallerThanItMustBe) {
  const auto probe = depth_scene({{{1.0, 2.0, -4.0}, 1.0, "ball"}}, 30.0);
  const Sheet plain = depth_sheet(probe);
  const double near = parallax(*plain.camera, -5.0), far = parallax(*plain.camera, 30.0);
  ASSERT_GT(std::fabs(near), far);
  const Sheet sheet = depth_sheet(probe, with_budget(0.5));
  const double factor = sheet.camera->sheet().lens().depth_factor;
  EXPECT_NEAR(factor, 0.5 / std::fabs(near), 2e-3 * factor);
  const DepthSurvey seen = survey_depth(*sheet.camera, probe, std::uint64_t{1} << 40);
  EXPECT_LE(std::fabs(parallax(*sheet.camera, seen.nearest)), 0.5);
  EXPECT_LE(parallax(*sheet.camera, seen.farthest), 0.5);
  bool told = false;
  for (const std::string& line : sheet.report) {
    told = told || line.starts_with("Depth_Budget 0.5 pixels a view: depth is compressed to ");
  }
  EXPECT_TRUE(told);
  // On the print.
  const double pitch = plain.camera->sheet().lens().print_pitch();
  EXPECT_NEAR(
      depth_sheet(probe, with_budget(0.5 * pitch, true)).camera->sheet().lens().depth_factor,
      factor, 1e-9);
  // What is within already stays.
  EXPECT_EQ(depth_sheet(probe, with_budget(100.0)).camera->sheet().lens().depth_factor, 1.0);
  // Snell's law, and V infinite.
  for (const LensModel model : {LensModel::kPinhole, LensModel::kThick}) {
    Conversion parallel = with_budget(0.5);
    parallel.lens.view_distance = 0.0;
    parallel.lens.model = model;
    const Sheet s = depth_sheet(probe, parallel);
    const DepthSurvey found = survey_depth(*s.camera, probe, std::uint64_t{1} << 40);
    const double most = found.largest_step();
    EXPECT_LE(most, 0.5);
    EXPECT_GT(most, 0.49);
  }
}

TEST(UnitCameraDepthBudget, TheSkyIsToldOf) {
  const auto probe = depth_scene({{{1.0, 2.0, 0.0}, 1.0, "ball"}});
  const auto says = [](const Sheet& sheet, const char* text) {
    for (const std::string& line : sheet.report) {
      if (line.starts_with(text)) return true;
    }
    return false;
  };
  EXPECT_TRUE(says(depth_sheet(probe, with_budget(0.2)),
                   "The background is not within the budget: it moves by "));
  EXPECT_TRUE(
      says(depth_sheet(probe, with_budget(100.0)), "The background is within the budget: "));
  Conversion parallel = with_budget(0.2);
  parallel.lens.view_distance = 0.0;
  EXPECT_TRUE(says(depth_sheet(probe, parallel),
                   "The background is not within the budget: it is infinitely far"));
  EXPECT_TRUE(says(depth_sheet(depth_scene({}), with_budget(0.2)),
                   "Depth_Budget 0.2 pixels a view: no point of an object is visible"));
}

TEST(ErrorCameraDepthBudget, APointAtTheEyesHasNoFactor) {
  const auto probe = depth_scene({{{1.0, 2.0, -10.0}, 1e-7, "ball"}});
  try {
    depth_sheet(probe, with_budget(1.0));
    FAIL();
  } catch (const CameraError& error) {
    const std::string said = error.what();
    EXPECT_NE(
        said.find("Depth_Budget 1 pixels a view: depth would be nothing, for a visible point"),
        said.npos)
        << said;
    EXPECT_EQ(said.find("inf"), said.npos) << said;
    EXPECT_EQ(said.find("nan"), said.npos) << said;
  }
}

/// The proposal is tried: a sheet that stands there has the figures that were told.
TEST(UnitCameraDepthBudget, AProposedStandBalancesNearAndFar) {
  const auto probe = depth_scene({{{1.0, 2.0, -4.0}, 1.0, "ball"}}, 30.0);
  for (const std::optional<double> distance : {std::optional<double>(), std::optional(250.0)}) {
    Conversion conversion;
    conversion.lens.view_distance = distance;
    const Sheet sheet = depth_sheet(probe, conversion);
    const auto stand = balanced_stand(*sheet.camera, sheet.stand, -5.0, 30.0);
    ASSERT_TRUE(stand);
    EXPECT_NEAR(stand->nearest_step, -stand->farthest_step, 1e-6);
    // From the eye 5 to 40: the harmonic mean where V is the camera's own distance.
    if (!distance) {
      EXPECT_NEAR(stand->distance, 2.0 / (1.0 / 5.0 + 1.0 / 40.0), 1e-3);
    }
    conversion.sheet_distance = stand->distance;
    const Sheet moved = depth_sheet(probe, conversion);
    EXPECT_NEAR(parallax(*moved.camera, 5.0 - stand->distance), stand->nearest_step, 1e-2);
    EXPECT_NEAR(parallax(*moved.camera, 40.0 - stand->distance), stand->farthest_step, 1e-2);
  }
  // V infinite: the middle.
  Conversion parallel;
  parallel.lens.view_distance = 0.0;
  const Sheet sheet = depth_sheet(probe, parallel);
  const auto stand = balanced_stand(*sheet.camera, sheet.stand, -5.0, 30.0);
  ASSERT_TRUE(stand);
  EXPECT_NEAR(stand->distance, 22.5, 1e-2);
  EXPECT_FALSE(balanced_stand(*sheet.camera, sheet.stand, 3.0, 3.0));
}

TEST(UnitCameraDepthBudget, TheReportTellsWhatStandsOut) {
  const auto probe =
      depth_scene({{{1.0, 2.0, -4.0}, 1.0, "ball"}, {{0.0, 2.0, 0.0}, 0.3, "bead"}}, 30.0);
  const Sheet sheet = depth_sheet(probe);
  std::string all;
  for (const std::string& line :
       depth_report(*sheet.camera, sheet.stand, survey_depth(*sheet.camera, probe))) {
    all += line + "\n";
  }
  for (const char* part :
       {"Nearest visible point 5 before the sheet: parallax -", " mm on the print",
        "Farthest visible point 30 behind the sheet: parallax ",
        "Sharp, up to 1 pixel a view: from ", "Without jumps, up to 1.5 pixels a view: from ",
        "Found with ",
        "Objects, the nearest first:\n  ball: 5 to 6.266 from the camera (Sheet_Distance=5.562), -",
        "  bead: 9.7 to ", "  plane: ", "; jumps", "; not sharp all over",
        "Proposed, for all that is visible: Sheet_Distance=",
        "For all but the nearest and the farthest twentieth of that: Sheet_Distance="}) {
    EXPECT_NE(all.find(part), all.npos) << part << "\n" << all;
  }
  EXPECT_EQ(all.find("Background"), all.npos) << all;
  EXPECT_EQ(all.find("inf"), all.npos) << all;
}

}  // namespace
}  // namespace lentray::camera
