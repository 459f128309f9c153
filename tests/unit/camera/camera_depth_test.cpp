// Depth of a lens sheet: parallax with a depth factor, sharp ranges, the survey of what is visible.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>

#include "camera/depth_survey.h"
#include "camera/parallax.h"
#include "camera/sheet_views.h"
#include "camera/slanted_lenticular.h"
#include "core/pass/pass_list.h"
#include "tests/unit/camera/depth_scene.h"
#include "tests/unit/camera/slanted_sheets.h"

namespace lentray::camera {
namespace {

using core::Ray;
using core::Vec3;

/// The most that a camera's neighbouring views move a point, in pixels of a view, by their rays alone:
/// where the line from each eye to the point passes the sheet's plane z = 0.
double moved_by_rays(const Lenticular& sheet, std::uint32_t view, const Vec3& point) {
  double at[2];
  for (const std::uint32_t j : {view, view + 1}) {
    const SheetView camera(sheet, j);
    Ray left, right;
    EXPECT_TRUE(camera.ray(0.5, 0.5, left) &&
                camera.ray(static_cast<double>(camera.width()) - 0.5, 0.5, right));
    // Of a finite V: the eye is where rays start.
    EXPECT_LT(core::length(left.origin - right.origin), 1e-9);
    const Vec3 eye = left.origin;
    at[j - view] = eye.x + (point.x - eye.x) * (0.0 - eye.z) / (point.z - eye.z);
  }
  return (at[0] - at[1]) / (sheet.sheet().lens().pitch * sheet.scale());
}

TEST(UnitCameraDepth, AFactorBringsTheViewsTogetherByAsMuch) {
  const Sheet sheet = depth_sheet({});
  LensParameters lens = sheet.camera->sheet().lens();
  lens.depth_factor = 0.3;
  const Lenticular close(lens, sheet.camera->placement(), 640, 480);
  for (const double depth : {-4.0, 0.0, 6.0, 300.0}) {
    const Vec3 point{1.4, 2.2, depth};
    EXPECT_NEAR(parallax(close, depth), 0.3 * parallax(*sheet.camera, depth), 1e-12);
    for (const std::uint32_t view : {0u, 7u, 13u}) {
      EXPECT_NEAR(moved_by_rays(close, view, point), parallax(close, depth), 1e-10) << depth;
    }
  }
  EXPECT_NEAR(parallax(close, core::Bounds::kInf),
              0.3 * parallax(*sheet.camera, core::Bounds::kInf), 1e-12);
  // The print and the middle view stay.
  EXPECT_EQ(close.print_width(), sheet.camera->print_width());
  Ray a, b;
  ASSERT_TRUE(close.ray(7.5, 3.5, a) && sheet.camera->ray(7.5, 3.5, b));
  EXPECT_EQ(a.direction, b.direction);
  // Without a factor offsets are what they were, to the bit.
  for (std::uint32_t k = 0; k < 640; ++k) {
    const LensColumn& c = sheet.camera->sheet().column(k);
    EXPECT_EQ(c.lens_offset,
              c.cell_offset + c.axis * lens.focal_length / (lens.ior * lens.view_distance));
  }
}

/// Views in other sizes and quilts look through the same lenses.
/// Neighbouring pixels of a row differ in slope, so what they show of a depth lies apart.
TEST(UnitCameraDepth, SlantedSheetsHaveTheParallaxOfTheirRays) {
  for (const test::SlantReference& reference : {kSlantedSheets[0], kSlantedSheets[2]}) {
    for (const double factor : {1.0, 0.4}) {
      LensParameters lens = slanted_lens(reference);
      lens.depth_factor = factor;
      const SlantedLenticular sheet(lens, slanted_placement(reference, 0.05, 1.0), 120, 40);
      const SheetPlacement& place = sheet.placement();
      const auto slope = [&](double column) {
        Ray ray;
        EXPECT_TRUE(sheet.ray(column, 20.5, ray));
        return core::dot(ray.direction, place.right) / core::dot(ray.direction, place.normal);
      };
      // Three pixels beside one another lie under two lenses at most.
      double step = slope(61.5) - slope(60.5);
      if (step < 0.0) step = slope(62.5) - slope(61.5);
      ASSERT_GT(step, 0.0);
      const double lens_width = place.width / sheet.sheet().lenses();
      for (const double depth : {-1.5, 0.7, 3.0}) {
        const double far = 1.0 + depth / sheet.scale() / lens.view_distance;
        EXPECT_NEAR(parallax(sheet, depth), step * depth / far / lens_width, 1e-9)
            << reference.slant << ", " << factor << ", " << depth;
      }
    }
  }
}

TEST(UnitCameraDepth, ViewsOfOtherSizesHaveTheFactorToo) {
  const Sheet sheet = depth_sheet({});
  LensParameters lens = sheet.camera->sheet().lens();
  lens.depth_factor = 0.25;
  const Lenticular close(lens, sheet.camera->placement(), 640, 480);
  Ray wide, narrow, middle;
  ASSERT_TRUE(SizedView(*sheet.camera, 0, 5, 200, 100).ray(100.0, 50.0, wide));
  ASSERT_TRUE(SizedView(close, 0, 5, 200, 100).ray(100.0, 50.0, narrow));
  ASSERT_TRUE(SizedView(close, 2, 5, 200, 100).ray(100.0, 50.0, middle));
  EXPECT_GT(std::fabs(wide.origin.x - middle.origin.x), 0.1);
  EXPECT_NEAR(narrow.origin.x - middle.origin.x, 0.25 * (wide.origin.x - middle.origin.x), 1e-9);
}

TEST(UnitCameraDepth, RangesAreWhereParallaxIsWhatIsAskedFor) {
  for (const double distance : {0.0, 300.0}) {
    LensRequest request;
    request.view_distance = distance;
    request.model = LensModel::kParaxial;
    const Sheet sheet = sheet_of_statement(plain_camera(), request, 600, 300, {});
    for (const double pixels : {0.5, 1.0, 1.5}) {
      const DepthInterval range = depths_within(*sheet.camera, pixels);
      EXPECT_NEAR(parallax(*sheet.camera, range.nearest), -pixels, 1e-9);
      EXPECT_NEAR(parallax(*sheet.camera, range.farthest), pixels, 1e-9);
    }
  }
  // V infinite: 2 N t/n in all.
  LensRequest request;
  const Sheet sheet = sheet_of_statement(plain_camera(), request, 600, 300, {});
  const DepthInterval sharp = depths_within(*sheet.camera, kSharpParallax);
  EXPECT_NEAR((sharp.farthest - sharp.nearest) / sheet.camera->scale(), 2.0 * 15.0 * 3.03 / 1.6,
              1e-9);
  // So near to the eye that even the sky moves by less than a pixel: sharp to infinity.
  EXPECT_TRUE(std::isinf(depths_within(*depth_sheet({}).camera, 100.0).farthest));
}

/// With Snell's law the outer views are farther apart, and the figure is that of the two that are
/// farthest.
TEST(UnitCameraDepth, TheLargestParallaxIsThatOfOuterViews) {
  LensRequest request;
  request.pixels = 30.0;
  const Sheet sheet = sheet_of_statement(plain_camera(), request, 900, 30, {});
  const LensSheet& columns = sheet.camera->sheet();
  double most = 0.0;
  for (std::uint32_t k = 1; k < 30; ++k) {
    // Parallel rays: a point at the depth 1 moves by the difference of two slopes.
    most = std::max(most, (columns.column(k).slope - columns.column(k - 1).slope) /
                              (columns.lens().pitch * sheet.camera->scale()));
  }
  for (const double depth : {1.0, -1.0}) {  // of the sheet at z = -10
    const DepthSurvey seen = survey_depth(*sheet.camera, depth_scene({}, depth - 10.0));
    EXPECT_NEAR(depth > 0.0 ? seen.most_step : -seen.least_step, most, 1e-9);
    EXPECT_NEAR(seen.largest_step(), most, 1e-9);
  }
  EXPECT_GT(most, 1.01 * parallax(*sheet.camera, 1.0));
  const Sheet paraxial = depth_sheet({});
  for (const double depth : {-5.0, 3.0}) {
    const DepthSurvey seen = survey_depth(*paraxial.camera, depth_scene({}, depth));
    EXPECT_NEAR(seen.least_step, parallax(*paraxial.camera, depth), 1e-9);
    EXPECT_NEAR(seen.most_step, seen.least_step, 1e-9);
  }
  const double bend = 1.6 / 3.03;
  const auto parallax_at_bend = [](const Lenticular& s, double depth, double by) {
    return parallax_rule(s, by).at(depth / s.scale());
  };
  EXPECT_NEAR(parallax_at_bend(*paraxial.camera, 4.0, bend), parallax(*paraxial.camera, 4.0),
              1e-12);
  EXPECT_LT(parallax_at_bend(*paraxial.camera, -11.0, bend), -1e9);  // behind the eye
}

TEST(UnitCameraDepth, ASurveyFindsTheExtremesOfLargeSheets) {
  // Small balls near the sheet's corners, that a coarse grid's rays touch beside their nearest points.
  const auto probe =
      depth_scene({{{-1.0, 4.0, -3.0}, 0.25, "near"}, {{3.0, 0.5, 6.0}, 0.3, "b"}}, 20.0);
  const Sheet sheet = depth_sheet(probe, {}, 2400, 1800);
  const DepthSurvey seen = survey_depth(*sheet.camera, probe, 1 << 16);
  EXPECT_FALSE(seen.is_whole);
  EXPECT_LT(seen.rays, 100'000u);
  EXPECT_NEAR(seen.nearest, -3.25, 1e-3);
  EXPECT_NEAR(seen.farthest, 20.0, 1e-9);
  // The balls are less than a twentieth.
  EXPECT_NEAR(seen.near_part, 20.0, 1e-9);
  EXPECT_NEAR(seen.far_part, 20.0, 1e-9);
  EXPECT_EQ(seen.background, 0.0);
  ASSERT_EQ(seen.objects.size(), 3u);
  EXPECT_EQ(seen.objects[0].name, "near");
  EXPECT_EQ(seen.objects[2].name, "plane");
  double all = 0.0;
  for (const SeenObject& object : seen.objects) all += object.share;
  EXPECT_NEAR(all, 1.0, 1e-12);
  // Seen from above: the wall is a line, the ball no wider than itself.
  for (const PlanPoint& p : seen.objects[2].outline) EXPECT_NEAR(p.depth, 20.0, 1e-9);
  for (const PlanPoint& p : seen.objects[0].outline) {
    EXPECT_NEAR(p.x, -2.0, 0.251);
    EXPECT_NEAR(p.depth, -3.0, 0.251);
  }
  // Pixel by pixel it is the same.
  const DepthSurvey whole = survey_depth(*sheet.camera, probe, std::uint64_t{1} << 40);
  EXPECT_TRUE(whole.is_whole);
  EXPECT_EQ(whole.rays, 2400u * 1800u);
  EXPECT_NEAR(whole.nearest, seen.nearest, 1e-4);
  EXPECT_NEAR(whole.objects[0].share, seen.objects[0].share, 0.002);
}

bool same(const DepthSurvey& a, const DepthSurvey& b) {
  const auto same_object = [](const SeenObject& x, const SeenObject& y) {
    return x.name == y.name && x.nearest == y.nearest && x.farthest == y.farthest &&
           x.share == y.share && x.outline == y.outline;
  };
  return a.nearest == b.nearest && a.farthest == b.farthest && a.near_part == b.near_part &&
         a.far_part == b.far_part && a.least_step == b.least_step && a.most_step == b.most_step &&
         a.background == b.background && a.rays == b.rays && a.is_whole == b.is_whole &&
         std::ranges::equal(a.objects, b.objects, same_object);
}

TEST(UnitCameraDepth, ASurveyIsTheSameOnAnyNumberOfThreads) {
  std::vector<DepthBall> balls;
  const char* const names[] = {"a", "b", "c", "d", "e", "f"};
  for (int i = 0; i < 6; ++i) balls.push_back({{i - 3.0, 0.7 * i, 1.7 * i - 4.0}, 0.6, names[i]});
  const SceneProbe probe = depth_scene(balls, 20.0);
  const Sheet sheet = depth_sheet(probe, {}, 1200, 300);
  for (const std::uint64_t most : {kSurveyRays, std::uint64_t{1} << 13}) {
    const DepthSurvey one = survey_depth(*sheet.camera, probe, most);
    EXPECT_EQ(one.is_whole, most == kSurveyRays);
    EXPECT_GE(one.objects.size(), 5u);
    for (const unsigned threads : {2u, 5u}) {
      DepthSurveyPass pass(*sheet.camera, probe, most);
      core::PassList passes;
      passes.add(pass);
      ASSERT_TRUE(passes.run({.threads = threads}));
      EXPECT_TRUE(same(pass.result(), one)) << threads;
      EXPECT_EQ(passes.reports().at(0).numbers.at(0).second, static_cast<double>(one.rays));
      const auto ask = [&](const core::Ray& ray, double limit) { return probe(ray, limit); };
      EXPECT_TRUE(same(survey_depth(*sheet.camera, {ask, threads}, most), one)) << threads;
    }
  }
}

TEST(UnitCameraDepth, ASurveyIsCancelled) {
  std::atomic<bool> cancel{false};
  std::atomic<int> rays{0};
  const SceneProbe probe = [&](const core::Ray&, double) -> std::optional<ProbeHit> {
    if (++rays == 1000) cancel = true;
    return std::nullopt;
  };
  const Sheet sheet = depth_sheet(depth_scene({}, 20.0), {}, 600, 400);
  DepthSurveyPass pass(*sheet.camera, probe);
  core::PassList passes;
  passes.add(pass);
  EXPECT_FALSE(passes.run({.threads = 2, .cancel = &cancel}));
  EXPECT_LT(rays, 4000);
}

TEST(UnitCameraDepth, TheBackgroundHasItsShare) {
  const auto probe = depth_scene({{{1.0, 2.0, 0.0}, 1.0, "ball"}});
  const Sheet sheet = depth_sheet(probe, {}, 300, 225);
  const DepthSurvey seen = survey_depth(*sheet.camera, probe);
  EXPECT_TRUE(seen.is_whole);
  ASSERT_EQ(seen.objects.size(), 1u);
  EXPECT_NEAR(seen.background + seen.objects[0].share, 1.0, 1e-12);
  // From the eye, 10 before it, the ball covers about pi of the sheet's 80/9 * 20/3.
  EXPECT_NEAR(seen.objects[0].share, M_PI * 100.0 / 99.0 / (80.0 / 9.0 * 20.0 / 3.0), 0.003);
  EXPECT_FALSE(survey_depth(*sheet.camera, {}).has_points());
}

TEST(UnitCameraDepth, OutlinesAreConvexAndHoldAllPoints) {
  std::vector<PlanPoint> points;
  for (int i = 0; i < 1000; ++i) {
    const double a = i * 2.399963, r = std::sqrt(i / 1000.0);
    points.push_back({r * std::cos(a), 2.0 * r * std::sin(a)});
  }
  const std::vector<PlanPoint> outline = convex_outline(points);
  ASSERT_GE(outline.size(), 8u);
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const PlanPoint &a = outline[i], &b = outline[(i + 1) % outline.size()];
    for (const PlanPoint& p : points) {
      EXPECT_GE((b.x - a.x) * (p.depth - a.depth) - (b.depth - a.depth) * (p.x - a.x), -1e-12);
    }
  }
  EXPECT_EQ(convex_outline({{1, 2}, {1, 2}}).size(), 1u);
  EXPECT_TRUE(convex_outline({}).empty());
}

}  // namespace
}  // namespace lentray::camera
