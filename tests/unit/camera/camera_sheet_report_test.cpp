// What is said of a sheet: sizes, parallax, the lens model's error, and what it runs into.
#include "camera/sheet_report.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "camera/conversion.h"
#include "camera/sheet_collisions.h"
#include "tests/unit/camera/plain_camera.h"

namespace lentray::camera {
namespace {

using core::Bounds;
using core::Ray;
using core::Vec3;

SceneProbe plane_at(const Vec3& normal, double distance) {
  return [=](const Ray& ray, double limit) -> std::optional<ProbeHit> {
    const double along = core::dot(ray.direction, normal);
    if (along == 0.0) return std::nullopt;
    const double t = (distance - core::dot(ray.origin, normal)) / along;
    if (t <= 1e-9 || t >= limit) return std::nullopt;
    static const int kId = 0;
    return ProbeHit{t, "plane", &kId};
  };
}

/// `id` tells balls apart.
SceneProbe ball_at(const Vec3& centre, double radius, const void* id = "ball") {
  return [=](const Ray& ray, double limit) -> std::optional<ProbeHit> {
    const Vec3 o = ray.origin - centre, r{radius, radius, radius};
    const double a = core::length_squared(ray.direction), b = core::dot(o, ray.direction);
    const double under = b * b - a * (core::length_squared(o) - radius * radius);
    if (under < 0.0) return std::nullopt;
    for (const double t : {(-b - std::sqrt(under)) / a, (-b + std::sqrt(under)) / a}) {
      if (t > 1e-9 && t < limit)
        return ProbeHit{t, "sphere", id, [=] { return Bounds{centre - r, centre + r}; }};
    }
    return std::nullopt;
  };
}

SceneProbe both(SceneProbe a, SceneProbe b) {
  return [=](const Ray& ray, double limit) -> std::optional<ProbeHit> {
    const auto p = a(ray, limit), q = b(ray, limit);
    if (p && q) return p->distance < q->distance ? p : q;
    return p ? p : q;
  };
}

Sheet sheet_of(const SceneProbe& probe, const Conversion& conversion = {}) {
  return sheet_of_camera("perspective", plain_camera(), conversion, 640, 480, probe);
}

Conversion from_infinity() {
  Conversion conversion;
  conversion.lens.view_distance = 0.0;
  return conversion;
}

bool camera_sheet_report_has_line(const std::vector<std::string>& lines, const std::string& part) {
  for (const std::string& line : lines) {
    if (line.find(part) != std::string::npos) return true;
  }
  return false;
}

std::string all(const std::vector<std::string>& lines) {
  std::string out;
  for (const std::string& line : lines) out += line + "\n";
  return out;
}

TEST(UnitCameraSheetReport, ParallaxOfPoints) {
  LensRequest lens;
  const Sheet sheet = sheet_of_statement(plain_camera(), lens, 600, 30, {});
  // V infinite: neighbouring views differ by n ps/f in slope.
  const double mm = 1.0 / sheet.camera->scale();
  EXPECT_NEAR(parallax(*sheet.camera, 1.0), 1.6 * (1.124 / 15.0) / 3.03 * mm / 1.124, 1e-13);
  EXPECT_NEAR(parallax(*sheet.camera, -1.0), -parallax(*sheet.camera, 1.0), 1e-15);
  lens.view_distance = 100.0;
  const Sheet finite = sheet_of_statement(plain_camera(), lens, 600, 30, {});
  const double eyes = 100.0 * 1.6 * finite.camera->sheet().lens().pixel_size() / 3.03;
  const double depth = mm;  // one scene unit
  EXPECT_NEAR(parallax(*finite.camera, 1.0), eyes * depth / (100.0 + depth) / 1.124, 1e-13);
  EXPECT_NEAR(parallax(*finite.camera, Bounds::kInf), eyes / 1.124, 1e-13);
}

/// The parallax is what rays show: a point behind the sheet, found in two neighbouring views.
TEST(UnitCameraSheetReport, ParallaxIsWhatTheViewsShow) {
  const Sheet sheet = sheet_of({});
  for (const double depth : {-3.0, 0.0, 5.0, 400.0}) {
    const Vec3 point{1.3, 2.1, depth};
    double columns[2];
    for (const std::uint32_t view : {7u, 8u}) {
      // The lens axis that lies on the line from the view's eye to the point.
      const SheetView camera(*sheet.camera, view);
      Ray ray;
      ASSERT_TRUE(camera.ray(0.5, 0.5, ray));
      const double at = ray.origin.x + (point.x - ray.origin.x) * 10.0 / (10.0 + depth);
      columns[view - 7] = (at - 1.0) / (sheet.camera->sheet().lens().pitch * sheet.camera->scale());
    }
    // View 8's eye is left of view 7's; what lies behind the sheet goes along with it.
    EXPECT_NEAR(parallax(*sheet.camera, depth), columns[0] - columns[1], 1e-12) << depth;
  }
}

TEST(UnitCameraSheetReport, SizesAndResolution) {
  const Sheet sheet = sheet_of(plane_at({0, 0, 1}, 5.0), from_infinity());
  // 640 pixels at N = 15: 42.67 lenses of 1.124 mm, and the rows as wide as the columns.
  EXPECT_TRUE(camera_sheet_report_has_line(sheet.report,
                                           "Lens sheet 47.9573 x 35.968 mm (1.88808 x 1.41606 in)"))
      << all(sheet.report);
  EXPECT_TRUE(camera_sheet_report_has_line(sheet.report, "22.5979 lpi, 15 pixels a lens"));
  EXPECT_TRUE(camera_sheet_report_has_line(sheet.report, "338.968 x 338.968 ppi"));
  // The eye at V: the print is larger than the sheet, its pixels further apart.
  const Sheet finite = sheet_of(plane_at({0, 0, 1}, 5.0));
  const double larger = 1.0 + 3.03 / (1.6 * finite.camera->sheet().lens().view_distance);
  EXPECT_NEAR(finite.camera->print_dpi_x(), 338.96797153024912 / larger, 1e-9);
  EXPECT_TRUE(camera_sheet_report_has_line(finite.report, "Lens sheet 47.9573 x"))
      << all(finite.report);
  EXPECT_TRUE(camera_sheet_report_has_line(finite.report, "Print 49.")) << all(finite.report);
}

/// Bounds of large objects take long to find.
TEST(UnitCameraSheetReport, AsksForTheBoundsOfAnObjectOnce) {
  int asked = 0;
  const SceneProbe ball = ball_at({1, 2, 0}, 1.0);
  const Sheet sheet = sheet_of([&](const Ray& ray, double limit) {
    std::optional<ProbeHit> hit = ball(ray, limit);
    if (!hit) return hit;
    hit->bounds = [&asked, bounds = hit->bounds] {
      ++asked;
      return bounds();
    };
    return hit;
  });
  EXPECT_TRUE(camera_sheet_report_has_line(sheet.report, "Nearest visible point"));
  EXPECT_EQ(asked, 1);
}

TEST(UnitCameraSheetReport, NearestAndFarthestVisiblePoints) {
  // A ball before the sheet hides one half as near to the eye; a wall stands behind both.
  const Sheet sheet = sheet_of(both(
      both(ball_at({1, 2, -2}, 1.0, "a"), ball_at({1, 2, 1}, 0.5, "b")), plane_at({0, 0, 1}, 5.0)));
  EXPECT_TRUE(camera_sheet_report_has_line(sheet.report, "Nearest visible point 2.9"))
      << all(sheet.report);
  EXPECT_TRUE(camera_sheet_report_has_line(sheet.report, "before the sheet: parallax -"));
  EXPECT_TRUE(camera_sheet_report_has_line(sheet.report,
                                           "Farthest visible point 5 behind the sheet: parallax "));
  EXPECT_FALSE(camera_sheet_report_has_line(sheet.report, "Background"));
  const Sheet open = sheet_of(ball_at({1, 2, 2}, 1.0));
  EXPECT_TRUE(camera_sheet_report_has_line(open.report, "Background, infinitely far: parallax "));
  // Small steps from view to view are not remarked upon, large ones are.
  EXPECT_FALSE(camera_sheet_report_has_line(sheet_of(plane_at({0, 0, 1}, 0.1)).report, "jumps"));
  EXPECT_TRUE(camera_sheet_report_has_line(sheet_of(plane_at({0, 0, 1}, 400.0)).report,
                                           "over all views; the eye sees jumps"));
  EXPECT_TRUE(
      camera_sheet_report_has_line(sheet_of(ball_at({1, 2, 2}, 1.0), from_infinity()).report,
                                   "Background, infinitely far: it moves along with the eye"));
  const Sheet empty = sheet_of([](const Ray&, double) { return std::optional<ProbeHit>(); });
  EXPECT_FALSE(camera_sheet_report_has_line(empty.report, "Nearest"));
}

TEST(UnitCameraSheetReport, ErrorOfTheParaxialModel) {
  LensParameters lens;
  // The outermost pixel of a lens, o = 7/15 P: Snell's law sends it to another slope; where would
  // it have to lie to be sent along the paraxial one?
  const double o = 7.0 / 15.0 * 1.124, slope = 1.6 * o / 3.03;
  const double inside = std::asin(std::sin(std::atan(slope)) / 1.6);
  const double want = (o - 3.03 * std::tan(inside)) / (1.124 / 15.0);
  const LensSheet sheet(lens, 45);
  EXPECT_NEAR(sheet.paraxial_error(), want, 1e-12);
  EXPECT_EQ(sheet.cheapest_model(want * 1.0001), LensModel::kParaxial);
  EXPECT_EQ(sheet.cheapest_model(want * 0.9999), LensModel::kPinhole);
  lens.model = LensModel::kParaxial;  // whatever model is used
  EXPECT_EQ(LensSheet(lens, 45).paraxial_error(), sheet.paraxial_error());
  lens.ior = 1.0;  // no refraction: the models are one
  EXPECT_NEAR(LensSheet(lens, 45).paraxial_error(), 0.0, 1e-12);
  // From a near eye the outer lenses are looked at obliquely.
  lens.ior = 1.6;
  lens.view_distance = 60.0;
  EXPECT_GT(LensSheet(lens, 600).paraxial_error(), LensSheet(lens, 45).paraxial_error());
}

/// One line tells the model and never advises against itself.
TEST(UnitCameraSheetReport, TellsTheModelAndWhatAnotherWouldDo) {
  EXPECT_TRUE(camera_sheet_report_has_line(sheet_of({}, from_infinity()).report,
                                           "Lens model pinhole: paraxial rays would be off Snell's "
                                           "law by at most 0.158104 pixels of the "
                                           "print, so that paraxial would do"));
  Conversion fine = from_infinity();
  fine.lens.pixels = 30.0;
  const auto report = sheet_of({}, fine).report;
  EXPECT_TRUE(
      camera_sheet_report_has_line(report, "Lens model pinhole: paraxial rays would be off"));
  EXPECT_FALSE(camera_sheet_report_has_line(report, "paraxial would do"));
  EXPECT_TRUE(camera_sheet_report_has_line(
      sheet_of({}).report,
      "Lens model paraxial: each view is a picture that any renderer can make, its rays are off "
      "Snell's law by at most "));
  fine.lens.model = LensModel::kParaxial;
  EXPECT_TRUE(camera_sheet_report_has_line(sheet_of({}, fine).report,
                                           "Lens model paraxial: its rays are off Snell's law"));
}

TEST(UnitCameraSheetReport, AnAutomaticModelKeepsTheTolerance) {
  Conversion conversion = from_infinity();
  conversion.lens.automatic_model = true;
  const Sheet paraxial = sheet_of({}, conversion);
  EXPECT_EQ(paraxial.camera->sheet().lens().model, LensModel::kParaxial);
  EXPECT_TRUE(camera_sheet_report_has_line(paraxial.report,
                                           "Lens model paraxial, the cheapest within 0.25 pixels: "
                                           "paraxial rays are off Snell's law by at "
                                           "most 0.158104 pixels of the print"))
      << all(paraxial.report);
  conversion.lens.tolerance = 0.1;
  const Sheet pinhole = sheet_of({}, conversion);
  EXPECT_EQ(pinhole.camera->sheet().lens().model, LensModel::kPinhole);
  EXPECT_TRUE(camera_sheet_report_has_line(pinhole.report,
                                           "Lens model pinhole, the cheapest within 0.1 pixels"));
  EXPECT_TRUE(pinhole.warnings.empty());
  // Of a near eye paraxial rays are further off: with V finite it chooses too, and of a statement.
  Conversion near;
  near.lens.automatic_model = true;
  EXPECT_EQ(sheet_of({}, near).camera->sheet().lens().model, LensModel::kPinhole);
  near.lens.tolerance = 1000.0;
  EXPECT_EQ(sheet_of({}, near).camera->sheet().lens().model, LensModel::kParaxial);
  LensRequest statement;
  statement.automatic_model = true;
  EXPECT_EQ(sheet_of_statement(plain_camera(), statement, 600, 30, {}).camera->sheet().lens().model,
            LensModel::kParaxial);
  statement.automatic_model = false;
  statement.tolerance = 1.0;
  EXPECT_TRUE(camera_sheet_report_has_line(
      sheet_of_statement(plain_camera(), statement, 600, 30, {}).warnings,
      "Lens_Tolerance has no effect"));
}

/// A sheet of 40 lenses an inch, 100 x 75 mm, of 15 pixels a lens.
LensRequest camera_sheet_report_print(double distance) {
  LensRequest lens;
  lens.lpi = 40.0;
  lens.thickness = 0.9;
  lens.ior = 1.57;
  lens.pixels = 15.0;
  lens.view_distance = distance;
  return lens;
}

TEST(UnitCameraSheetReport, WhatTheEyesSee) {
  const LensRequest lens = camera_sheet_report_print(400.0);
  const Sheet sheet = sheet_of_statement(plain_camera(), lens, 2362, 30, {});
  // tan t of the edge of a strip P' wide, by Snell's law.
  const double strip = 0.635 * (1.0 + 0.9 / (1.57 * 400.0));
  const double out = std::asin(1.57 * std::sin(std::atan(0.5 * strip / 0.9)));
  char text[160];
  std::snprintf(
      text, sizeof text,
      "Viewing angle %.4g degrees; at 400 mm the zone to view it from is %.4g mm wide, and "
      "a view %.4g mm",
      out * 360.0 / M_PI, 800.0 * std::tan(out), 800.0 * std::tan(out) / 15.0);
  EXPECT_TRUE(camera_sheet_report_has_line(sheet.report, text)) << text << all(sheet.report);
  // The strip's place that the left eye sees, 32.5 mm beside the middle: right of the lens's axis.
  const double inside = std::asin(std::sin(std::atan(32.5 / 400.0)) / 1.57);
  const double place = 0.9 * std::tan(inside) / (strip / 15.0);  // pixels from the strip's middle
  const int left = static_cast<int>(7.5 + place), right = static_cast<int>(7.5 - place);
  std::snprintf(text, sizeof text, "The left eye sees view %d, the right eye view %d of 0 to 14",
                left, right);
  EXPECT_TRUE(camera_sheet_report_has_line(sheet.report, text)) << text << all(sheet.report);
  EXPECT_GT(left, right);
  EXPECT_TRUE(sheet.warnings.empty()) << all(sheet.warnings);
  LensRequest fractional = lens;
  fractional.pixels = 15.5;
  EXPECT_TRUE(camera_sheet_report_has_line(
      sheet_of_statement(plain_camera(), fractional, 2362, 30, {}).report,
      "of the 15.5 pixels behind each lens"));
  LensRequest parallel = lens;
  parallel.view_distance = 0.0;
  const Sheet far = sheet_of_statement(plain_camera(), parallel, 2362, 30, {});
  EXPECT_TRUE(camera_sheet_report_has_line(far.report, "Viewing angle 62.97 degrees"))
      << all(far.report);
  EXPECT_FALSE(camera_sheet_report_has_line(far.report, "left eye"));
}

/// The views that the report names for the eyes are those whose own eyes are nearest to them.
TEST(UnitCameraSheetReport, TheEyesViewsAreThoseWhoseRaysMeetThere) {
  LensRequest lens = camera_sheet_report_print(400.0);
  lens.model = LensModel::kPinhole;
  const Sheet sheet = sheet_of_statement(plain_camera(), lens, 2362 / 15 * 15, 30, {});
  const LensSheet& columns = sheet.camera->sheet();
  const std::uint32_t middle = columns.lens_count() / 2;
  int left = 0, right = 0;
  double left_miss = 1e9, right_miss = 1e9;
  for (std::uint32_t view = 0; view < 15; ++view) {
    const auto column = static_cast<std::uint32_t>(view_column(15.0, view, 15, middle));
    ASSERT_LT(column, columns.width());
    // Where the pixel's ray comes from, at the eyes' distance.
    const double x = columns.column(column).axis - 400.0 * columns.column(column).slope;
    if (std::fabs(x + 32.5) < left_miss) left = static_cast<int>(view);
    if (std::fabs(x - 32.5) < right_miss) right = static_cast<int>(view);
    left_miss = std::min(left_miss, std::fabs(x + 32.5));
    right_miss = std::min(right_miss, std::fabs(x - 32.5));
  }
  EXPECT_TRUE(camera_sheet_report_has_line(
      sheet.report, "left eye sees view " + std::to_string(left) + ", the right eye view " +
                        std::to_string(right)))
      << left << " " << right << "\n"
      << all(sheet.report);
}

TEST(ErrorCameraSheetReport, EyesThatSeeNoDepth) {
  const auto warnings = [](double distance) {
    return sheet_of_statement(plain_camera(), camera_sheet_report_print(distance), 2362, 30, {})
        .warnings;
  };
  EXPECT_TRUE(camera_sheet_report_has_line(
      warnings(50.0), "less than the 65 mm between two eyes: depth is reversed; "))
      << all(warnings(50.0));
  EXPECT_TRUE(camera_sheet_report_has_line(
      warnings(1000.0), "more than the 65 mm between two eyes: there is little depth or none"))
      << all(warnings(1000.0));
  EXPECT_TRUE(warnings(400.0).empty());
  EXPECT_TRUE(warnings(0.0).empty());
}

TEST(UnitCameraSheetReport, WhatAPrintStillNeeds) {
  EXPECT_TRUE(camera_sheet_report_has_line(
      sheet_of({}).report,
      "For a print say also: Lens_Sheet or Lens_LPI (your sheet's), Print_DPI (your printer's), "
      "Sheet_Width and Sheet_Height, View_Distance (yours; this is the scene's camera's)"));
  LensRequest all_said = camera_sheet_report_print(400.0);
  all_said.pixels.reset();
  all_said.print_dpi = 600.0;
  all_said.size = SheetSize{100.0, 75.0, {}, false};
  const ExactPixels exact = exact_pixels(all_said, *all_said.size);
  const Sheet sheet = sheet_of_statement(plain_camera(), all_said,
                                         static_cast<std::uint32_t>(std::lround(exact.columns)),
                                         static_cast<std::uint32_t>(std::lround(exact.rows)), {});
  EXPECT_FALSE(camera_sheet_report_has_line(sheet.report, "For a print")) << all(sheet.report);
}

TEST(UnitCameraSheetReport, WhereTheLensesFocus) {
  LensRequest lens;
  lens.pitch = 0.33665;
  lens.thickness = 0.457;
  lens.radius = 0.1905;
  lens.ior = 1.557;
  // 1.557 x 0.1905/0.557 = 0.53250: the light of a far eye, P wide at the lens, is still
  // P (0.53250 - 0.457)/0.53250 wide on the back: 14.18 % of the 15 pixels.
  const Sheet behind = sheet_of_statement(plain_camera(), lens, 600, 30, {});
  EXPECT_TRUE(camera_sheet_report_has_line(
      behind.report,
      "The lenses focus 0.07551 mm behind the sheet's back: an eye sees 2.127 pixels of the print"))
      << all(behind.report);
  lens.thickness = 0.6;
  EXPECT_TRUE(
      camera_sheet_report_has_line(sheet_of_statement(plain_camera(), lens, 600, 30, {}).report,
                                   "The lenses focus 0.06749 mm before"));
  lens.thickness = 0.53;
  EXPECT_TRUE(
      camera_sheet_report_has_line(sheet_of_statement(plain_camera(), lens, 600, 30, {}).report,
                                   "The lenses focus on the sheet's back"));
  lens.sheet_name = "40lpi";
  lens.sheet_is_nominal = true;
  EXPECT_TRUE(camera_sheet_report_has_line(
      sheet_of_statement(plain_camera(), lens, 600, 30, {}).report, "Lens_Sheet=40lpi is nominal"));
}

/// The thick model has the radius that was given: out of focus, a pixel's rays spread.
TEST(UnitCameraSheetReport, TheThickModelIsOutOfFocusToo) {
  const auto spread = [](double radius) {
    LensRequest lens;
    lens.pitch = 0.2;
    lens.thickness = 1.5;
    lens.radius = radius;
    lens.ior = 1.5;
    lens.model = LensModel::kThick;
    lens.rays = 2;
    const Sheet sheet = sheet_of_statement(plain_camera(), lens, 45, 1, {});
    core::PixelPlace place;
    place.column = 22;
    core::Ray a, b;
    EXPECT_TRUE(sheet.camera->one_ray_at(place, {0, {-0.25, 0.0}}, a));
    EXPECT_TRUE(sheet.camera->one_ray_at(place, {1, {0.25, 0.0}}, b));
    return core::length(core::cross(a.direction, b.direction));
  };
  EXPECT_LT(spread(0.5), 3e-3);  // n R/(n - 1) is the thickness
  EXPECT_GT(spread(0.3), 2e-2);
  EXPECT_GT(spread(0.9), 2e-2);
}

TEST(UnitCameraSheetReport, PinholeTellsHowFarRaysMissTheEye) {
  EXPECT_FALSE(camera_sheet_report_has_line(sheet_of({}).report, "miss the eyes"));
  EXPECT_FALSE(camera_sheet_report_has_line(sheet_of({}, from_infinity()).report, "miss the eyes"));
  Conversion snell;
  snell.lens.model = LensModel::kPinhole;
  EXPECT_TRUE(camera_sheet_report_has_line(sheet_of({}, snell).report,
                                           "Rays miss the eyes of their views by at most "));
}

// What a sheet runs into. The sheet of plain_camera() is 8.9 x 6.7 units at z = 0, its eye 10 units
// before it, the eyes of the outermost views some 2.9 to either side.

TEST(ErrorCameraCollisions, AnObjectAcrossTheSheet) {
  const Sheet sheet = sheet_of(ball_at({1, 2, 0}, 1.0));
  EXPECT_TRUE(
      camera_sheet_report_has_line(sheet.warnings, "the lens sheet cuts an object (sphere)"))
      << all(sheet.warnings);
  EXPECT_EQ(sheet.warnings.size(), 1u);
  // Also with the eye infinitely far.
  EXPECT_TRUE(camera_sheet_report_has_line(
      sheet_of(ball_at({1, 2, 0}, 1.0), from_infinity()).warnings, "cuts an object"));
  // Two of a kind are counted, the hidden second along a line too.
  EXPECT_TRUE(camera_sheet_report_has_line(
      sheet_of(both(ball_at({-1, 2, 0}, 0.6, "a"), ball_at({2, 2, 0}, 0.6, "b"))).warnings,
      "(2 sphere)"));
}

TEST(ErrorCameraCollisions, ObjectsBesideTheSheetAreNone) {
  for (const Vec3& centre : {Vec3{1, 2, 1.5}, Vec3{1, 2, -1.5}, Vec3{8, 2, 0}, Vec3{1, 8, 0}}) {
    EXPECT_TRUE(sheet_of(ball_at(centre, 1.0)).warnings.empty()) << centre.x << " " << centre.z;
  }
}

TEST(ErrorCameraCollisions, HiddenObjectsAreNone) {
  // Below an opaque floor, across the plane of the sheet.
  const SceneProbe scene = both(ball_at({1, 0, 0}, 0.4), plane_at({0, 1, 0}, 0.5));
  EXPECT_TRUE(sheet_of(scene).warnings.empty()) << all(sheet_of(scene).warnings);
  const SceneProbe above = both(ball_at({1, 1.2, 0}, 0.4), plane_at({0, 1, 0}, 0.5));
  EXPECT_TRUE(camera_sheet_report_has_line(sheet_of(above).warnings, "(sphere)"));
}

TEST(ErrorCameraCollisions, FloorsAreSceneryNotObjects) {
  const Sheet floor = sheet_of(plane_at({0, 1, 0}, 0.5));
  EXPECT_TRUE(floor.warnings.empty()) << all(floor.warnings);
  EXPECT_TRUE(
      camera_sheet_report_has_line(floor.report,
                                   "Larger than the sheet and running through it, as floors do: "
                                   "plane"));
  // A planet for a floor.
  const Sheet ground = sheet_of(ball_at({1, -49.5, 0}, 50.0));
  EXPECT_TRUE(ground.warnings.empty()) << all(ground.warnings);
  EXPECT_TRUE(camera_sheet_report_has_line(ground.report, "as floors do: sphere"));
  // The sky around everything.
  const Sheet sky = sheet_of(ball_at({0, 0, 0}, 1000.0));
  EXPECT_TRUE(sky.warnings.empty());
  EXPECT_FALSE(camera_sheet_report_has_line(sky.report, "as floors do"));
}

TEST(ErrorCameraCollisions, TheEyesRunIntoAnObject) {
  const Sheet ball = sheet_of(ball_at({2.5, 2.0, -10.0}, 0.3));
  EXPECT_TRUE(camera_sheet_report_has_line(ball.warnings, "run into an object (sphere)"))
      << all(ball.warnings);
  EXPECT_FALSE(camera_sheet_report_has_line(ball.warnings, "sheet cuts"));
  // Walls count though they are infinite. Eyes stand at 1 - (j - 7) n ps V/f.
  const Sheet wall = sheet_of(plane_at({1, 0, 0}, 3.0));
  const LensParameters& lens = wall.camera->sheet().lens();
  const double step = 10.0 * lens.ior * lens.pixel_size() / lens.focal_length;
  const int last = 7 - static_cast<int>(std::ceil(2.0 / step));
  ASSERT_GT(last, 0);
  EXPECT_TRUE(
      camera_sheet_report_has_line(wall.warnings,
                                   "run into an object (plane): seen from inside or behind it: "
                                   "views 0 to " +
                                       std::to_string(last)))
      << all(wall.warnings);
  EXPECT_TRUE(sheet_of(plane_at({1, 0, 0}, 1.0 + 7.01 * step)).warnings.empty());
  EXPECT_TRUE(camera_sheet_report_has_line(
      sheet_of(plane_at({1, 0, 0}, 1.0 + 6.99 * step)).warnings, "it: view 0"));
  EXPECT_TRUE(camera_sheet_report_has_line(
      sheet_of(plane_at({1, 0, 0}, 1.0 - 6.99 * step)).warnings, "it: view 14"));
}

TEST(ErrorCameraCollisions, RaysStartInAPlaneWhenTheEyeIsFar) {
  // V infinite: rays start 10 before the sheet, some of them below the floor.
  const Sheet floor = sheet_of(plane_at({0, 1, 0}, 0.5), from_infinity());
  EXPECT_TRUE(
      camera_sheet_report_has_line(floor.warnings,
                                   "the plane where rays start, 10 scene units before the sheet "
                                   "(Lens_Front), cuts an object (plane)"))
      << all(floor.warnings);
  EXPECT_TRUE(sheet_of(plane_at({0, 1, 0}, -1.5), from_infinity()).warnings.empty());
  // A start between eye and sheet.
  Conversion near;
  near.lens.front = 4.0;
  EXPECT_TRUE(camera_sheet_report_has_line(sheet_of(ball_at({1, 2, -4}, 0.5), near).warnings,
                                           "where rays start, 4 "));
  EXPECT_TRUE(sheet_of(ball_at({1, 2, -6}, 0.5), near).warnings.empty());
  EXPECT_TRUE(sheet_of(ball_at({1, 2, -4}, 0.5)).warnings.empty());
}

TEST(ErrorCameraCollisions, AnOrthographicSheetIsWhereRaysStart) {
  Projection p = plain_camera();
  p.right = {4.0, 0.0, 0.0};
  p.up = {0.0, 3.0, 0.0};
  const Sheet cut = sheet_of_camera("orthographic", p, {}, 640, 480, ball_at({1, 2, -10}, 1.0));
  ASSERT_EQ(cut.warnings.size(), 1u) << all(cut.warnings);
  EXPECT_TRUE(camera_sheet_report_has_line(cut.warnings,
                                           "where rays start, 0 scene units before the sheet"));
  EXPECT_TRUE(
      sheet_of_camera("orthographic", p, {}, 640, 480, ball_at({1, 2, -8}, 1.0)).warnings.empty());
}

}  // namespace
}  // namespace lentray::camera
