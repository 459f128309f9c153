// Where a composed sheet stands, how much depth it shows, and what is said of it.
#include "camera/composition.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "camera/conversion.h"
#include "camera/parallax.h"
#include "core/base/joined.h"
#include "tests/unit/camera/depth_scene.h"

namespace lentray::camera {
namespace {

/// The camera is at z = -10, so that distances are z + 10.
constexpr double kComposedCamera = 10.0;

Conversion composed_print(DepthMode mode = DepthMode::kPrint) {
  Conversion out;
  out.lens.depth = mode;
  out.lens.view_distance = 400.0;
  return out;
}

/// The most that anything moves, by a ray through each pixel.
double moves_most(const Lenticular& sheet, const SceneProbe& probe) {
  const DepthSurvey seen = survey_depth(sheet, probe, std::uint64_t{1} << 40);
  const double sky = seen.background > 0.0 ? parallax(sheet, core::Bounds::kInf) : 0.0;
  return std::max(seen.largest_step(), sky);
}

bool composition_says(const std::vector<std::string>& lines, const std::string& part) {
  return std::ranges::any_of(
      lines, [&](const std::string& line) { return line.find(part) != std::string::npos; });
}

TEST(UnitCameraComposition, TheSheetStandsAtTheHarmonicMeanOfAllDepths) {
  const auto probe = depth_scene({{{1.0, 2.0, -6.5}, 1.0, "ball"}}, 12.0);
  const Sheet sheet = depth_sheet(probe, composed_print());
  const double near = 2.5, far = 22.0;  // the ball's front, the wall
  EXPECT_NEAR(sheet.camera->eye_distance(), 2.0 * near * far / (near + far), 2e-3);
  EXPECT_NEAR(sheet.stand->distance, sheet.camera->eye_distance(), 1e-9);
  // Both ends move by as much, by no more than the budget, and by hardly less.
  const double distance = sheet.camera->eye_distance();
  EXPECT_NEAR(parallax(*sheet.camera, near - distance), -parallax(*sheet.camera, far - distance),
              2e-3);
  EXPECT_LE(moves_most(*sheet.camera, probe), kMostParallax);
  EXPECT_GT(moves_most(*sheet.camera, probe), 0.96 * kMostParallax);
  EXPECT_LT(sheet.camera->depth_factor(), 1.0);
  EXPECT_TRUE(sheet.warnings.empty());
}

TEST(UnitCameraComposition, TheBackgroundIsKeptWithinTheBudget) {
  const auto probe = depth_scene({{{1.0, 2.0, -4.0}, 1.0, "ball"}});
  for (const LensModel model : {LensModel::kParaxial, LensModel::kPinhole, LensModel::kThick}) {
    Conversion asked = composed_print();
    asked.lens.model = model;
    const Sheet sheet = depth_sheet(probe, asked);
    EXPECT_NEAR(sheet.camera->eye_distance(), 2.0 * 5.0, 2e-3);
    EXPECT_LE(moves_most(*sheet.camera, probe), kMostParallax);
    EXPECT_GT(moves_most(*sheet.camera, probe), 0.95 * kMostParallax);
  }
  // A floor that goes on and on is as good as a background.
  SceneDepths floor{{5.0, 5000.0}, false, {}};
  EXPECT_EQ(balanced_distance(floor, true), 10.0);
  EXPECT_EQ(balanced_distance(floor, false), 2502.5);
  EXPECT_EQ(balanced_distance({}, true), std::nullopt);
}

TEST(UnitCameraComposition, NothingIsCompressedMoreThanItMustBe) {
  const auto probe = depth_scene({{{1.0, 2.0, 0.0}, 0.1, "ball"}}, 0.2);
  const Sheet flat = depth_sheet(probe, composed_print());
  EXPECT_EQ(flat.camera->depth_factor(), 1.0);
  EXPECT_TRUE(composition_says(flat.report, "; true depth")) << core::joined(flat.report, "\n");
  // A viewer who is nearer would have to turn the eyes outwards for the wall.
  Conversion near = composed_print(DepthMode::kScene);
  near.lens.view_distance = 30.0;
  const Sheet cut = depth_sheet(depth_scene({}, 30.0), near);
  const double eye = kComposedCamera / cut.camera->scale();  // mm
  EXPECT_NEAR(cut.camera->depth_factor(), 30.0 / (eye * (1.0 - 10.0 / 40.0)), 1e-3);
}

/// Eyes stay on this side of what is beside the camera.
TEST(UnitCameraComposition, EyesOfViewsDoNotRunIntoObjects) {
  const auto probe =
      depth_scene({{{2.3, 2.0, -10.0}, 1.0, "post"}, {{1.0, 2.0, 3.0}, 1.0, "ball"}}, 10.0);
  for (const double pixels : {15.0, 2.3, 7.4}) {
    Conversion asked = composed_print();
    asked.lens.pixels = pixels;
    const Sheet sheet = depth_sheet(probe, asked);
    EXPECT_NEAR(sheet.stand->distance, 2.0 * 12.0 * 20.0 / 32.0, 2e-3);
    const Lenticular& s = *sheet.camera;
    double farthest = 0.0;  // beside the camera, that an eye is
    for (std::uint32_t k = 0; k < s.width(); ++k) {
      const LensColumn& c = s.sheet().column(k);
      farthest =
          std::max(farthest, std::fabs(c.axis * s.scale() - s.eye_distance() * s.scene_slope(c)));
    }
    EXPECT_LT(farthest, 0.3) << pixels;
    EXPECT_FALSE(composition_says(sheet.warnings, "cut: ")) << core::joined(sheet.warnings, "\n");
    EXPECT_EQ(composition_says(sheet.report, ", with more an eye would be in post"),
              sheet.composed->is_held);
    if (pixels == 15.0) {
      EXPECT_TRUE(sheet.composed->is_held);
    }
  }
  EXPECT_TRUE(
      composition_says(depth_sheet(probe, composed_print(DepthMode::kScene)).warnings, "cut: "));
}

TEST(UnitCameraComposition, SheetAtPutsAnObjectIntoThePlane) {
  const auto probe = depth_scene({{{1.0, 2.0, -4.0}, 1.0, "Ball at a.pov:3:1"},
                                  {{2.5, 2.0, 2.0}, 1.0, "Ball at a.pov:9:1"},
                                  {{-1.5, 2.0, 5.0}, 1.0, "Cup at a.pov:12:1"}},
                                 30.0);
  for (const char* const name : {"Cup", "a.pov:12:1", "Cup at a.pov:12:1"}) {
    for (const DepthMode mode : {DepthMode::kPrint, DepthMode::kScene, DepthMode::kViewer}) {
      Conversion asked = composed_print(mode);
      asked.sheet_at = name;
      const Sheet sheet = depth_sheet(probe, asked);
      const double distance = sheet.stand->distance;
      EXPECT_GT(distance, 14.0) << name;
      EXPECT_LT(distance, 15.0) << name;  // its visible front, harmonically
      EXPECT_EQ(sheet.composed.has_value(), mode != DepthMode::kViewer);
    }
  }
  const auto complaint = [&](const char* name) -> std::string {
    Conversion asked = composed_print();
    asked.sheet_at = name;
    try {
      (void)depth_sheet(probe, asked);
    } catch (const CameraError& error) {
      return error.what();
    }
    return {};
  };
  EXPECT_EQ(complaint("Ball"),
            "Sheet_At=Ball may be any of Ball at a.pov:3:1, Ball at a.pov:9:1: give its place, "
            "FILE:LINE:COLUMN");
  EXPECT_EQ(complaint("Chair"),
            "Sheet_At=Chair: no visible object is called so; there are plane, Ball at a.pov:3:1, "
            "Ball at a.pov:9:1, Cup at a.pov:12:1");
}

TEST(UnitCameraComposition, ThePlaceAndTheBudgetThatAreAskedForHold) {
  const auto probe = depth_scene({{{1.0, 2.0, -4.0}, 1.0, "ball"}}, 30.0);
  Conversion asked = composed_print();
  asked.sheet_distance = 7.0;
  asked.lens.depth_budget = DepthBudget{0.8, false};
  const Sheet sheet = depth_sheet(probe, asked);
  EXPECT_EQ(sheet.camera->eye_distance(), 7.0);
  EXPECT_LE(moves_most(*sheet.camera, probe), 0.8);
  EXPECT_GT(moves_most(*sheet.camera, probe), 0.77);
  // The scene's own depth may jump, and says so.
  const Sheet deep = depth_sheet(probe, composed_print(DepthMode::kScene));
  EXPECT_EQ(deep.camera->eye_distance(), kComposedCamera);
  EXPECT_GT(moves_most(*deep.camera, probe), kMostParallax);
  EXPECT_TRUE(composition_says(deep.warnings, "jumps: ")) << core::joined(deep.warnings, "\n");
  EXPECT_TRUE(composition_says(deep.report, "Jumps: ball"));
}

TEST(UnitCameraComposition, AnAnimationHasOneSheetForAllFrames) {
  const auto near = depth_scene({{{1.0, 2.0, -4.0}, 1.0, "ball"}}, 30.0);
  const auto far = depth_scene({{{1.0, 2.0, 8.0}, 1.0, "ball"}}, 30.0);
  SceneDepths all = depth_sheet(near, composed_print()).composed->depths;
  all.add(depth_sheet(far, composed_print()).composed->depths);
  Conversion asked = composed_print();
  asked.depths = all;
  const Sheet one = depth_sheet(near, asked), other = depth_sheet(far, asked);
  EXPECT_EQ(one.camera->eye_distance(), other.camera->eye_distance());
  EXPECT_EQ(one.camera->depth_factor(), other.camera->depth_factor());
  EXPECT_TRUE(one.warnings.empty());
  EXPECT_TRUE(other.warnings.empty());
  // What comes nearer in between is named.
  const auto nearer = depth_scene({{{1.0, 2.0, -7.0}, 1.0, "ball"}}, 30.0);
  const Sheet beyond = depth_sheet(nearer, asked);
  EXPECT_EQ(beyond.camera->depth_factor(), one.camera->depth_factor());
  EXPECT_TRUE(composition_says(beyond.warnings, "jumps: ball, by up to"))
      << core::joined(beyond.warnings, "\n");
}

TEST(UnitCameraComposition, APrintThatIsNearlyFlatSaysSoAndWhy) {
  const auto probe =
      depth_scene({{{1.0, 2.0, -9.0}, 0.02, "fly"}, {{3.0, 2.0, 50.0}, 5.0, "ball"}}, 60.0);
  const Sheet sheet = depth_sheet(probe, composed_print());
  EXPECT_TRUE(composition_says(sheet.warnings, "flat: nine tenths of the picture lie "))
      << core::joined(sheet.warnings, "\n");
  EXPECT_TRUE(composition_says(sheet.warnings, ": fly is much nearer, "));
}

TEST(UnitCameraComposition, TheReportBeginsWithThreeLines) {
  const auto probe = depth_scene({{{1.0, 2.0, -2.0}, 1.0, "ball"}}, 30.0);
  const Sheet sheet = depth_sheet(probe, composed_print());
  ASSERT_GE(sheet.report.size(), 3u);
  EXPECT_TRUE(sheet.report[0].starts_with("In the sheet's plane, 11.")) << sheet.report[0];
  EXPECT_TRUE(sheet.report[1].starts_with("Depth: ")) << sheet.report[1];
  EXPECT_TRUE(sheet.report[2].starts_with("Jumps: none")) << sheet.report[2];
}

// What the report says of depth is where an eye at V sees the point: two views' lines to it meet there.
TEST(UnitCameraComposition, TheDepthThatIsToldIsWhereEyesSeeIt) {
  const auto probe = depth_scene({}, 30.0);
  Conversion asked = composed_print();
  asked.sheet_distance = 20.0;
  const Sheet sheet = depth_sheet(probe, asked);
  const Lenticular& s = *sheet.camera;
  const LensParameters& lens = s.sheet().lens();
  const double step = parallax(s, 20.0) * lens.pitch;  // mm on the sheet, from view to view
  const double eyes = lens.ior * lens.pixel_size() / lens.focal_length * lens.view_distance;
  const double depth = lens.view_distance * step / (eyes - step);  // behind, by similar triangles
  char text[64];
  std::snprintf(text, sizeof text, "Depth: from %.4g mm to %.4g mm behind", depth, depth);
  EXPECT_TRUE(sheet.report[1].starts_with(text)) << sheet.report[1] << "\n" << text;
}

TEST(UnitCameraComposition, ParallelRaysHaveTheSheetInTheMiddle) {
  Projection p = plain_camera();
  p.right = {8.0, 0.0, 0.0};
  p.up = {0.0, 6.0, 0.0};
  p.look_at_distance.reset();
  const auto probe = depth_scene({{{1.0, 2.0, -4.0}, 1.0, "ball"}}, 30.0);
  const Sheet sheet = sheet_of_camera("orthographic", p, composed_print(), 640, 480, probe);
  EXPECT_FALSE(sheet.camera->has_near_eye());
  EXPECT_NEAR(sheet.stand->distance, 0.5 * (5.0 + 40.0), 2e-3);
  EXPECT_LE(moves_most(*sheet.camera, probe), kMostParallax);
  EXPECT_GT(moves_most(*sheet.camera, probe), 0.96 * kMostParallax);
}

}  // namespace
}  // namespace lentray::camera
