// Sheets made of existing cameras: where they stand, what they show, what is refused and said.
#include "camera/conversion.h"

#include <gtest/gtest.h>

#include <cmath>

#include "camera/projected.h"
#include "core/base/bounds.h"
#include "tests/unit/camera/plain_camera.h"

namespace lentray::camera {
namespace {

using core::Ray;
using core::Vec3;

/// A world of one infinite wall across z.
SceneProbe wall_at(double z) {
  return [z](const Ray& ray, double limit) -> std::optional<ProbeHit> {
    if (ray.direction.z == 0.0) return std::nullopt;
    const double t = (z - ray.origin.z) / ray.direction.z;
    if (t <= 1e-9 || t >= limit) return std::nullopt;
    return ProbeHit{t, "plane"};
  };
}

std::string message(const auto& work) {
  try {
    work();
  } catch (const CameraError& error) {
    return error.what();
  }
  return {};
}

bool has_line(const std::vector<std::string>& lines, const std::string& part) {
  for (const std::string& line : lines) {
    if (line.find(part) != std::string::npos) return true;
  }
  return false;
}

void expect_same_line(const Ray& a, const Ray& b, double tolerance) {
  EXPECT_LT(core::length(core::cross(a.direction, b.direction)), tolerance);
  EXPECT_LT(core::length(core::cross(b.origin - a.origin, a.direction)), tolerance);
}

TEST(UnitCameraConversion, TheMiddleViewIsTheOrdinaryPicture) {
  const Projection p = plain_camera();
  const Sheet sheet = sheet_of_camera("perspective", p, {}, 600, 30, {});
  const Projected ordinary(ProjectedKind::kPerspective, p, {}, 40, 30);
  const SheetView view(*sheet.camera, 7);
  EXPECT_EQ(view.width(), 40u);
  EXPECT_EQ(sheet.camera->sheet().lens().model, LensModel::kParaxial);
  for (const double row : {0.5, 14.5, 29.5}) {
    for (const double column : {0.5, 20.5, 39.5}) {
      Ray a, b;
      ASSERT_TRUE(ordinary.ray(column, row, a));
      ASSERT_TRUE(view.ray(column, row, b));
      EXPECT_LT(core::length(a.direction - b.direction), 1e-13);
      EXPECT_LT(core::length(a.origin - b.origin), 1e-12);  // rays start in the eye's plane
    }
  }
  EXPECT_TRUE(has_line(sheet.report, "where the camera looks at"));
}

TEST(UnitCameraConversion, AnObliqueAndMirroredCameraStaysSo) {
  Projection p = plain_camera();
  p.right = -p.right;
  p.direction = {0.3, -0.2, 1.5};
  p.look_at_distance = 7.0;
  const Sheet sheet = sheet_of_camera("perspective", p, {}, 600, 30, {});
  const Projected ordinary(ProjectedKind::kPerspective, p, {}, 40, 30);
  const SheetView view(*sheet.camera, 7);
  for (const double row : {0.5, 29.5}) {
    for (const double column : {0.5, 39.5}) {
      Ray a, b;
      ASSERT_TRUE(ordinary.ray(column, row, a));
      ASSERT_TRUE(view.ray(column, row, b));
      EXPECT_LT(core::length(a.direction - b.direction), 1e-13);
      EXPECT_LT(core::length(a.origin - b.origin), 1e-12);
    }
  }
  // The sheet's middle lies along direction, as far as look_at.
  EXPECT_NEAR(core::length(sheet.camera->placement().centre - p.location), 7.0, 1e-13);
}

TEST(UnitCameraConversion, SheetDistanceMovesTheZeroParallaxPlane) {
  Conversion conversion;
  conversion.sheet_distance = 4.0;
  const Sheet sheet = sheet_of_camera("perspective", plain_camera(), conversion, 600, 30, {});
  EXPECT_NEAR(sheet.camera->placement().centre.z, -6.0, 1e-14);
  EXPECT_NEAR(sheet.camera->placement().width, 4.0 / 3.0 * 4.0 / 1.5, 1e-14);
  EXPECT_NEAR(sheet.camera->placement().front, 4.0, 1e-14);
  // V in mm: the eye's distance over s.
  const LensParameters& lens = sheet.camera->sheet().lens();
  EXPECT_NEAR(lens.view_distance * sheet.camera->scale(), 4.0, 1e-13);
}

TEST(UnitCameraConversion, WithoutLookAtTheMedianDepthCounts) {
  Projection p = plain_camera();
  p.look_at_distance.reset();
  const Sheet sheet = sheet_of_camera("perspective", p, {}, 600, 30, wall_at(5.0));
  EXPECT_NEAR(sheet.camera->placement().centre.z, 5.0, 1e-12);
  EXPECT_TRUE(has_line(sheet.report, "Sheet distance 15, the median depth"));
  const SceneProbe nothing = [](const Ray&, double) { return std::optional<ProbeHit>(); };
  EXPECT_NE(message([&] {
              (void)sheet_of_camera("perspective", p, {}, 600, 30, nothing);
            }).find("give Sheet_Distance"),
            std::string::npos);
}

TEST(UnitCameraConversion, InfiniteViewDistanceGivesParallelViews) {
  Conversion conversion;
  conversion.lens.view_distance = 0.0;
  const Sheet sheet = sheet_of_camera("perspective", plain_camera(), conversion, 600, 30, {});
  EXPECT_FALSE(sheet.camera->sheet().lens().is_finite());
  EXPECT_EQ(sheet.camera->sheet().lens().model, LensModel::kPinhole);
  EXPECT_NEAR(sheet.camera->placement().front, 10.0, 1e-13);
  Ray a, b;
  ASSERT_TRUE(sheet.camera->ray(3.5, 2.5, a));
  ASSERT_TRUE(sheet.camera->ray(303.5, 22.5, b));
  EXPECT_LT(core::length(a.direction - b.direction), 1e-15);
}

TEST(UnitCameraConversion, OrthographicIsThePicturePlane) {
  Projection p = plain_camera();
  p.direction = {0.2, 0.1, 1.0};  // oblique
  p.look_at_distance.reset();
  const Sheet sheet = sheet_of_camera("orthographic", p, {}, 600, 30, {});
  const Projected ordinary(ProjectedKind::kOrthographic, p, {}, 40, 30);
  const SheetView view(*sheet.camera, 7);
  EXPECT_FALSE(sheet.camera->sheet().lens().is_finite());
  EXPECT_EQ(sheet.camera->placement().front, 0.0);
  for (const double column : {0.5, 39.5}) {
    Ray a, b;
    ASSERT_TRUE(ordinary.ray(column, 3.5, a));
    ASSERT_TRUE(view.ray(column, 3.5, b));
    expect_same_line(a, b, 1e-12);  // pinhole: the print's shift allows for Snell's law
  }
  Conversion paraxial;
  paraxial.lens.model = LensModel::kParaxial;
  const Sheet exact = sheet_of_camera("orthographic", p, paraxial, 600, 30, {});
  const SheetView middle(*exact.camera, 7);
  Ray a, b;
  ASSERT_TRUE(ordinary.ray(11.5, 3.5, a));
  ASSERT_TRUE(middle.ray(11.5, 3.5, b));
  expect_same_line(a, b, 1e-12);
}

TEST(UnitCameraConversion, DpiAndPixelsSayTheSameThing) {
  // Each view's N from DPI and back, with V in mm and with V from the scene.
  for (const bool infinite : {true, false}) {
    Conversion conversion;
    conversion.lens.print_dpi = 300.0;
    if (infinite) conversion.lens.view_distance = 0.0;
    const Sheet sheet = sheet_of_camera("perspective", plain_camera(), conversion, 600, 450, {});
    EXPECT_NEAR(sheet.camera->print_dpi_x(), 300.0, 1e-9);
    // Agreeing values may both be given.
    conversion.lens.pixels = sheet.camera->sheet().lens().pixels;
    EXPECT_NO_THROW((void)sheet_of_camera("perspective", plain_camera(), conversion, 600, 450, {}));
    conversion.lens.pixels = 20.0;
    EXPECT_NE(message([&] {
                (void)sheet_of_camera("perspective", plain_camera(), conversion, 600, 450, {});
              }).find("contradict"),
              std::string::npos);
  }
  Conversion lpi;
  lpi.lens.lpi = 40.0;
  EXPECT_NEAR(
      sheet_of_camera("perspective", plain_camera(), lpi, 600, 30, {}).camera->sheet().lens().pitch,
      0.635, 1e-15);
  lpi.lens.pitch = 0.7;
  EXPECT_NE(message([&] {
              (void)sheet_of_camera("perspective", plain_camera(), lpi, 600, 30, {});
            }).find("contradict"),
            std::string::npos);
}

TEST(UnitCameraConversion, OptionsOverrideTheStatement) {
  LensRequest scene;
  scene.pitch = 1.0;
  scene.print_dpi = 300.0;
  scene.ior = 1.5;
  LensRequest options;
  options.lpi = 20.0;
  options.pixels = 14.0;
  scene.override_by(options);
  EXPECT_FALSE(scene.pitch);
  EXPECT_FALSE(scene.print_dpi);
  EXPECT_EQ(scene.lpi, 20.0);
  EXPECT_EQ(scene.pixels, 14.0);
  EXPECT_EQ(scene.ior, 1.5);
}

TEST(UnitCameraConversion, StatementDefaults) {
  Projection p = plain_camera();
  const Sheet sheet = sheet_of_statement(p, {}, 600, 30, {});
  EXPECT_EQ(sheet.camera->placement().centre, p.location);
  EXPECT_NEAR(sheet.camera->placement().front, 4.0 / 3.0, 1e-15);  // the sheet's width
  EXPECT_EQ(sheet.camera->sheet().lens().model, LensModel::kPinhole);
  LensRequest near;
  near.view_distance = 30.0;  // nearer than the sheet is wide
  const Sheet finite = sheet_of_statement(p, near, 600, 30, {});
  EXPECT_NEAR(finite.camera->placement().front, 30.0 * finite.camera->scale(), 1e-14);
  ASSERT_EQ(finite.warnings.size(), 1u);  // not of lens_front
  EXPECT_NE(finite.warnings[0].find("depth is reversed"), std::string::npos);
  EXPECT_TRUE(has_line(finite.report, "Rays miss the eyes"));
}

TEST(UnitCameraConversion, TheThickLensHasRays) {
  Conversion conversion;
  conversion.lens.model = LensModel::kThick;
  const Sheet usual = sheet_of_camera("perspective", plain_camera(), conversion, 600, 30, {});
  EXPECT_EQ(usual.camera->rays_a_place(), 16u);
  EXPECT_TRUE(usual.camera->missing_rays_are_black());
  EXPECT_TRUE(usual.warnings.empty());
  EXPECT_TRUE(has_line(usual.report, "Each pixel is the mean of 16 rays"));
  EXPECT_TRUE(has_line(usual.report, "Rays miss the eyes"));
  LensRequest scene, options;
  scene.rays = 5;
  options.rays = 7;
  options.model = LensModel::kThick;
  scene.override_by({});
  EXPECT_EQ(scene.rays, 5u);
  scene.override_by(options);
  const Sheet sheet = sheet_of_statement(plain_camera(), scene, 600, 30, {});
  EXPECT_EQ(sheet.camera->rays_a_place(), 7u);
}

TEST(ErrorCameraConversion, RaysOfOtherModels) {
  LensRequest request;
  request.rays = 5;
  const Sheet statement = sheet_of_statement(plain_camera(), request, 600, 30, {});
  Conversion conversion;
  conversion.lens = request;
  const Sheet converted = sheet_of_camera("perspective", plain_camera(), conversion, 600, 30, {});
  for (const Sheet* sheet : {&statement, &converted}) {
    EXPECT_EQ(sheet->camera->rays_a_place(), 1u);
    EXPECT_FALSE(sheet->camera->missing_rays_are_black());
    ASSERT_EQ(sheet->warnings.size(), 1u);
    EXPECT_EQ(sheet->warnings[0],
              "the number of rays (lens_rays, Lens_Rays) has no effect: only the lens model thick "
              "has several");
  }
}

TEST(ErrorCameraConversion, ALensThatIsTooWide) {
  LensRequest request;
  request.model = LensModel::kThick;
  request.pitch = 3.0;
  request.focal_length = 3.03;
  EXPECT_NE(message([&] {
              (void)sheet_of_statement(plain_camera(), request, 600, 30, {});
            }).find("it can be 2.2725 mm wide at most, not 3 mm"),
            std::string::npos);
}

/// Lenses of five pixels of 0.1 mm, seen from infinitely far.
LensRequest sized_request() {
  LensRequest lens;
  lens.pitch = 0.5;
  lens.thickness = 1.5;
  lens.print_dpi = 254.0;  // 0.1 mm
  lens.view_distance = 0.0;
  return lens;
}

TEST(UnitCameraConversion, PixelsOfASheetsSize) {
  LensRequest lens = sized_request();
  SheetSize size{100.0, 70.0, {}, false};
  ExactPixels exact = exact_pixels(lens, size);
  EXPECT_NEAR(exact.columns, 1000.0, 1e-9);
  EXPECT_NEAR(exact.rows, 700.0, 1e-9);
  // From an eye at V the print is 1 + f/(nV) times as large.
  lens.view_distance = 300.0;
  exact = exact_pixels(lens, size);
  const double larger = 1.0 + 1.5 / (1.6 * 300.0);
  EXPECT_NEAR(exact.columns, 1000.0 * larger, 1e-9);
  EXPECT_NEAR(exact.rows, 700.0 * larger, 1e-9);
  size.dpi_down = 127.0;
  EXPECT_NEAR(exact_pixels(lens, size).rows, 350.0 * larger, 1e-9);
  // Pixels a lens instead: the resolution follows.
  lens.print_dpi.reset();
  lens.pixels = 7.5;
  size.dpi_down.reset();
  exact = exact_pixels(lens, size);
  EXPECT_NEAR(exact.columns, 1500.0, 1e-9);
  EXPECT_NEAR(exact.rows, 1050.0, 1e-9);
}

TEST(UnitCameraConversion, ASheetHasTheSizeThatWasAskedFor) {
  Conversion conversion;
  conversion.lens = sized_request();
  conversion.lens.view_distance = 300.0;
  conversion.lens.size = SheetSize{100.0, 70.0, {}, false};
  const double larger = 1.0 + 1.5 / (1.6 * 300.0);
  const Sheet sheet = sheet_of_camera("perspective", plain_camera(), conversion, 1003, 702, {});
  EXPECT_NEAR(sheet.camera->sheet().sheet_width(), 100.3 / larger, 1e-9);
  EXPECT_NEAR(sheet.camera->sheet_height(), 70.2 / larger, 1e-9);
  EXPECT_NEAR(sheet.camera->print_width(), 100.3, 1e-9);
  EXPECT_NEAR(sheet.camera->print_height(), 70.2, 1e-9);
  EXPECT_NEAR(sheet.camera->print_dpi_x(), 254.0, 1e-9);
  EXPECT_NEAR(sheet.camera->print_dpi_y(), 254.0, 1e-9);
  EXPECT_TRUE(
      has_line(sheet.report,
               "Rounded to whole pixels, 1003 x 702, for a sheet of 100 x 70 mm: 0.01246 mm "
               "narrower, 0.01869 mm lower"));
  // Other rows an inch, and rows that fill the sheet.
  conversion.lens.size->dpi_down = 127.0;
  EXPECT_NEAR(sheet_of_camera("perspective", plain_camera(), conversion, 1003, 351, {})
                  .camera->print_dpi_y(),
              127.0, 1e-9);
  conversion.lens.size->dpi_down.reset();
  conversion.lens.size->rows_fill_it = true;
  EXPECT_EQ(sheet_of_camera("perspective", plain_camera(), conversion, 1003, 55, {})
                .camera->sheet_height(),
            70.0);
}

TEST(ErrorCameraConversion, APictureOfAnotherShapeThanTheSheet) {
  Conversion conversion;
  conversion.lens = sized_request();
  conversion.lens.size = SheetSize{100.0, 70.0, {}, false};
  // plain_camera() is 4 : 3. A lens has 5 pixels, which is the first warning.
  const Sheet wide = sheet_of_camera("perspective", plain_camera(), conversion, 1000, 700, {});
  ASSERT_EQ(wide.warnings.size(), 2u);
  EXPECT_EQ(
      wide.warnings[1],
      "the camera's picture is 1.333 times as wide as high, the sheet 1.429 times: things look "
      "7.143 % too wide (right x*image_width/image_height in the camera would fit)");
  conversion.lens.size = SheetSize{100.0, 100.0, 127.0, false};
  const Sheet narrow = sheet_of_camera("perspective", plain_camera(), conversion, 1000, 500, {});
  ASSERT_EQ(narrow.warnings.size(), 2u);
  EXPECT_EQ(
      narrow.warnings[1],
      "the camera's picture is 1.333 times as wide as high, the sheet 1 times: things look 25 % "
      "too narrow (up y right 1*x in the camera would fit)");
  conversion.lens.size = SheetSize{100.0, 75.0, {}, false};
  EXPECT_EQ(
      sheet_of_camera("perspective", plain_camera(), conversion, 1000, 750, {}).warnings.size(),
      1u);
}

TEST(ErrorCameraConversion, AScenesOwnLensOfAnotherSize) {
  LensRequest lens = sized_request();
  lens.size = SheetSize{100.0, 75.0, {}, false};
  EXPECT_EQ(message([&] { (void)sheet_of_statement(plain_camera(), lens, 1000, 750, {}); }), "");
  EXPECT_EQ(message([&] { (void)sheet_of_statement(plain_camera(), lens, 900, 750, {}); }),
            "the scene's own lens makes the sheet 90 mm wide, not 100 mm: give its lens data and "
            "view_distance as options, from which the picture's columns follow");
  // Of a converted camera whose own eye is the viewer's, the print has that size.
  Conversion conversion;
  conversion.lens = lens;
  conversion.lens.view_distance.reset();
  const Sheet eye = sheet_of_camera("perspective", plain_camera(), conversion, 1000, 750, {});
  EXPECT_NEAR(eye.camera->print_width(), 100.0, 1e-9);
  EXPECT_LT(eye.camera->sheet().sheet_width(), 99.9);
  EXPECT_TRUE(has_line(eye.report, " mm narrower, "));
}

TEST(ErrorCameraConversion, RefusalsAreByName) {
  for (const char* kind : {"fisheye", "ultra_wide_angle", "omnimax", "panoramic", "spherical",
                           "cylinder", "mesh_camera", "user_defined"}) {
    EXPECT_NE(
        message([&] { (void)sheet_of_camera(kind, plain_camera(), {}, 640, 480, {}); }).find(kind),
        std::string::npos);
  }
  Projection skewed = plain_camera();
  skewed.up = {0.1, 1.0, 0.0};
  EXPECT_NE(message([&] {
              (void)sheet_of_camera("perspective", skewed, {}, 640, 480, {});
            }).find("not perpendicular"),
            std::string::npos);
  Projection flat = plain_camera();
  flat.direction = {1.0, 0.0, 0.0};
  EXPECT_NE(message([&] {
              (void)sheet_of_camera("perspective", flat, {}, 640, 480, {});
            }).find("picture plane"),
            std::string::npos);
  Conversion thin;
  thin.lens.pixels = 0.5;
  EXPECT_NE(message([&] {
              (void)sheet_of_camera("perspective", plain_camera(), thin, 640, 480, {});
            }).find("one pixel"),
            std::string::npos);
  for (const double distance : {1e-300, 1e300}) {
    Conversion absurd;
    absurd.sheet_distance = distance;
    EXPECT_NE(message([&] {
                (void)sheet_of_camera("perspective", plain_camera(), absurd, 640, 480, {});
              }),
              "");
  }
}

}  // namespace
}  // namespace lentray::camera
