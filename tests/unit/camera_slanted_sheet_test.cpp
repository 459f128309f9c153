// Slanted sheets: rays of all models against vectors refracted in long double, which pixel is whose,
// views, and that a slant of 0 is the upright sheet.
#include "camera/slanted_sheet.h"

#include <gtest/gtest.h>

#include <cmath>

#include "camera/lens_request.h"
#include "camera/sheet_views.h"
#include "camera/slanted_lenticular.h"
#include "camera/thick_lenticular.h"
#include "tests/support/slanted_reference.h"

namespace lentray::camera {
namespace {

using core::Ray;
using core::Vec3;
using test::SlantReal;
using test::SlantReference;
using Model = SlantReference::Model;

LensParameters slanted_lens(const SlantReference& s) {
  LensParameters lens{s.pitch, s.focal_length, s.ior, s.pixels};
  if (s.distance > 0.0) lens.view_distance = s.distance;
  lens.model = s.model == Model::kParaxial  ? LensModel::kParaxial
               : s.model == Model::kPinhole ? LensModel::kPinhole
                                            : LensModel::kThick;
  lens.rays = static_cast<std::uint32_t>(s.rays);
  lens.slant = static_cast<double>(std::tan(s.angle()));
  return lens;
}

/// A turned sheet, `scale` scene units a mm to the right and `stretch` times as many upwards.
SheetPlacement slanted_placement(const SlantReference& s, double scale, double stretch) {
  SheetPlacement place;
  place.centre = {1.3, -0.7, 2.1};
  place.right = {2.0 / 3.0, 1.0 / 3.0, -2.0 / 3.0};
  place.up = {-2.0 / 3.0, 2.0 / 3.0, -1.0 / 3.0};
  place.normal = {1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0};
  place.width = static_cast<double>(s.width()) * scale;
  place.height = static_cast<double>(s.height()) * scale * stretch;
  place.height_mm = static_cast<double>(s.height());
  place.front = 2.75;
  place.eye_slope_x = s.eye_slope_x;
  place.eye_slope_y = s.eye_slope_y * stretch;
  return place;
}

const SlantReference kSlantedSheets[] = {
    {.model = Model::kParaxial, .slant = 18.434948822922010648, .distance = 400.0},
    {.model = Model::kParaxial,
     .slant = -9.46,
     .pixels = 7.37,
     .distance = 250.0,
     .eye_slope_x = 0.2,
     .eye_slope_y = -0.1},
    {.model = Model::kParaxial,
     .slant = 30.0,
     .pixels = 5.5,
     .eye_slope_x = 0.1,
     .eye_slope_y = 0.25},
    {.model = Model::kPinhole, .slant = 18.434948822922010648},
    {.model = Model::kPinhole,
     .slant = -21.7,
     .pixels = 6.283,
     .distance = 300.0,
     .row_by_column = 2.0,
     .eye_slope_x = 0.15,
     .eye_slope_y = -0.2},
    {.model = Model::kPinhole,
     .slant = 60.0,
     .pixels = 9.1,
     .eye_slope_x = -0.2,
     .eye_slope_y = 0.1},
    {.model = Model::kThick, .slant = 18.434948822922010648, .rays = 5},
    {.model = Model::kThick,
     .slant = -12.0,
     .pixels = 6.6,
     .distance = 200.0,
     .row_by_column = 0.5,
     .eye_slope_x = 0.05,
     .eye_slope_y = 0.1,
     .rays = 4},
};

TEST(UnitCameraSlantedSheet, RaysAreThoseOfRefractedVectors) {
  for (const SlantReference& s : kSlantedSheets) {
    for (const double stretch : {1.0, 1.25}) {
      SCOPED_TRACE("slant " + std::to_string(s.slant) + " stretch " + std::to_string(stretch));
      constexpr double kScale = 0.125;
      const SheetPlacement place = slanted_placement(s, kScale, stretch);
      const SlantedLenticular camera(slanted_lens(s), place, static_cast<std::uint32_t>(s.columns),
                                     static_cast<std::uint32_t>(s.rows));
      EXPECT_NEAR(camera.scale(), kScale, 1e-15);
      int lit = 0;
      double largest = 0.0;
      for (int row = 0; row < s.rows; row += 3) {
        for (int column = 0; column < s.columns; ++column) {
          for (int j = 0; j < s.rays; ++j) {
            const auto want = slant_ray(s, column, row, (j + 0.5L) / s.rays);
            Ray got;
            const bool shows = camera.one_ray_at({.column = column, .row = row},
                                                 static_cast<std::uint32_t>(j), got);
            ASSERT_EQ(shows, want.has_value()) << column << ' ' << row << ' ' << j;
            if (!want) continue;
            ++lit;
            const auto world = [&](SlantReal x, SlantReal y, SlantReal z) {
              return place.right * static_cast<double>(x * kScale) +
                     place.up * static_cast<double>(y * kScale * stretch) +
                     place.normal * static_cast<double>(z * kScale);
            };
            const auto& at = want->leaves;
            // A mm into the display is kScale units of the direction.
            const Vec3 v = world(want->slope[0], want->slope[1], 1.0L) / kScale;
            const Vec3 from = place.centre + world(at[0], at[1], at[2]) -
                              v * (place.front + static_cast<double>(at[2]) * kScale);
            const Vec3 off = got.origin - from, turn = got.direction - core::normalized(v);
            largest = std::max({largest, core::length(off), core::length(turn)});
          }
        }
      }
      EXPECT_GT(lit, s.columns * s.rows / 6);
      EXPECT_LT(largest, 1e-12);
    }
  }
}

/// From a finite distance all paraxial rays of a print offset meet in one eye, beside the sheet's own.
TEST(UnitCameraSlantedSheet, ParaxialRaysMeetInTheEyesOfTheirViews) {
  const SlantReference& s = kSlantedSheets[1];
  const LensParameters lens = slanted_lens(s);
  const SheetPlacement place = slanted_placement(s, 1.0, 1.0);
  const SlantedLenticular camera(lens, place, 70, 40);
  const double v = lens.view_distance;
  for (int row = 0; row < 40; ++row) {
    for (int column = 0; column < 70; ++column) {
      Ray ray;
      ASSERT_TRUE(camera.ray(column + 0.5, row + 0.5, ray));
      const Vec3 from = ray.origin - place.centre;
      const double way =
          (-v - core::dot(from, place.normal)) / core::dot(ray.direction, place.normal);
      const Vec3 eye = from + ray.direction * way;
      const double offset =
          static_cast<double>(slant_pixel(s, column, row).cell_offset) / lens.slant_cosine();
      EXPECT_NEAR(core::dot(eye, place.right),
                  -v * (s.eye_slope_x + lens.ior * offset / lens.focal_length), 1e-10);
      EXPECT_NEAR(core::dot(eye, place.up), -v * s.eye_slope_y, 1e-10);
    }
  }
}

TEST(UnitCameraSlantedSheet, ASlantOfNoneIsTheUprightSheet) {
  for (SlantReference s : kSlantedSheets) {
    s.slant = 0.0;
    // Of pinholes, rows that are not level with the eye are skew here; upright ones leave that out.
    if (s.model == Model::kPinhole) s.distance = 0.0, s.eye_slope_y = 0.0;
    const LensParameters lens = slanted_lens(s);
    ASSERT_EQ(lens.slant, 0.0);
    const SheetPlacement place = slanted_placement(s, 0.125, 1.0);
    const SlantedLenticular slanted(lens, place, 70, 40);
    std::unique_ptr<Lenticular> upright;
    if (s.model == Model::kThick) {
      upright = std::make_unique<ThickLenticular>(lens, place, 70, 40);
    } else {
      upright = std::make_unique<Lenticular>(lens, place, 70, 40);
    }
    for (int column = 0; column < 70; ++column) {
      for (const int row : {0, 7, 39}) {
        Ray a, b;
        ASSERT_TRUE(upright->ray_at({.column = column, .row = row}, a));
        ASSERT_TRUE(slanted.ray_at({.column = column, .row = row}, b));
        EXPECT_LT(core::length(a.origin - b.origin), 1e-13);
        EXPECT_LT(core::length(a.direction - b.direction), 1e-13);
      }
    }
  }
}

TEST(UnitCameraSlantedSheet, TheOffsetSeenIsThatOfTheSlope) {
  for (const SlantReference& s : kSlantedSheets) {
    const SlantedSheet sheet(slanted_lens(s), {70, 40, 100.0, s.eye_slope_x, s.eye_slope_y});
    for (const double offset : {-0.6, -0.2, 0.0, 0.33}) {
      for (const double rise : {-0.3, 0.0, 0.2}) {
        double across = 0.0;
        ASSERT_TRUE(sheet.slope_across(offset, sheet.along(rise), across));
        EXPECT_NEAR(sheet.offset_seen(sheet.slope_x(across, rise), rise), offset, 1e-14);
      }
    }
  }
}

/// By hand: tan a = 1/3 and square pixels, N = 6. From one row to the next the strips go on by a third
/// of a column. The tops lean to the right.
TEST(UnitCameraSlantedSheet, StripsLeanToTheRight) {
  LensParameters lens;
  lens.pixels = 6.0;
  lens.slant = 1.0 / 3.0;
  const double pixel = lens.pitch / 6.0 / lens.slant_cosine();
  const SlantedSheet sheet(lens, {60, 30, 30.0 * pixel});
  EXPECT_NEAR(sheet.shift(0.0), 5.0, 1e-12);
  EXPECT_NEAR(sheet.shift(15.0), 0.0, 1e-12);
  EXPECT_NEAR(sheet.shift(30.0), -5.0, 1e-12);
  // Row 13 is 3/2 rows up and so half a column to the right: lens 5 begins at column 30.5, which is
  // the centre of pixel 30.
  EXPECT_EQ(sheet.lens_of(29, 13), 4);
  EXPECT_EQ(sheet.lens_of(30, 13), 5);
  EXPECT_EQ(sheet.lens_of(30, 12), 4);  // 5/6 columns to the right
  EXPECT_EQ(sheet.lens_of(29, 16), 5);  // half a column to the left
  EXPECT_EQ(sheet.lens_of(0, 29), 0);
  EXPECT_EQ(sheet.lens_of(0, 0), -1);
  EXPECT_EQ(sheet.lens_of(59, 29), 10);
}

/// The pixel of a view is the nearest one of all that its lens has.
TEST(UnitCameraSlantedSheet, AViewsPixelIsTheNearest) {
  for (const SlantReference& s : kSlantedSheets) {
    const SlantedSheet sheet(slanted_lens(s), {70, 40, static_cast<double>(s.height())});
    const std::int64_t lenses = std::lround(s.columns / s.pixels);
    for (int row = 0; row < 40; row += 3) {
      for (std::int64_t place = 2; place < lenses - 2; ++place) {
        const std::int64_t lens = sheet.nearest_lens(place, row);
        const double axis =
            sheet.x_of(sheet.axis_of(static_cast<double>(lens)), sheet.row_height(row + 0.5));
        const double wide = s.pitch / sheet.cosine();
        EXPECT_LE(std::fabs(axis - (place + 0.5 - 0.5 * sheet.lenses()) * wide), 0.5001 * wide);
        for (std::uint32_t view = 0; view < 5; ++view) {
          const double wanted = ((view + 0.5) / 5 - 0.5) * sheet.lens().print_pitch();
          double least = 1e9;
          std::uint32_t nearest = 0;
          for (std::uint32_t k = 0; k < 70; ++k) {
            if (sheet.lens_of(k, row) != lens) continue;
            const double off =
                std::fabs(sheet.place(k + 0.5, row + 0.5, lens).cell_offset - wanted);
            if (off < least - 1e-9) least = off, nearest = k;
          }
          EXPECT_NEAR(sheet.view_column(view, 5, place, row), nearest, 1.0);
          const auto got =
              sheet.place(sheet.view_column(view, 5, place, row) + 0.5, row + 0.5, lens);
          EXPECT_LE(std::fabs(got.cell_offset - wanted), least + 1e-7);
        }
      }
    }
  }
}

/// A picture of a view is a perspective from the view's eye, whatever its size.
TEST(UnitCameraSlantedSheet, PicturesOfViewsAreWhole) {
  const SlantReference& s = kSlantedSheets[1];
  const LensParameters lens = slanted_lens(s);
  const SheetPlacement place = slanted_placement(s, 1.0, 1.0);
  const SlantedLenticular camera(lens, place, 70, 40);
  const auto view = make_view(camera, 1, 4, 31, 17);
  const double e = (1.5 / 4 - 0.5) * lens.print_pitch() / lens.slant_cosine();
  const double v = lens.view_distance;
  const Vec3 eye = place.centre - place.normal * v -
                   place.right * (v * (s.eye_slope_x + lens.ior * e / lens.focal_length)) -
                   place.up * (v * s.eye_slope_y);
  for (int row = 0; row < 17; ++row) {
    for (int column = 0; column < 31; ++column) {
      Ray ray;
      ASSERT_TRUE(view->ray(column + 0.5, row + 0.5, ray));
      const Vec3 on_sheet = place.centre +
                            place.right * (((column + 0.5) / 31 - 0.5) * place.width) +
                            place.up * ((0.5 - (row + 0.5) / 17) * place.height);
      EXPECT_LT(core::length(ray.direction - core::normalized(on_sheet - eye)), 1e-12);
    }
  }
}

TEST(UnitCameraSlantedSheet, SizesAndResolution) {
  LensRequest asked;
  asked.pitch = 0.5;
  asked.slant = 0.75;  // cos a = 0.8
  asked.print_dpi = 508.0;
  const LensParameters lens = resolve(asked, 1000, nullptr);
  EXPECT_NEAR(lens.pixels, 12.5, 1e-12);  // 0.5 mm/0.8 at 20 pixels a mm
  EXPECT_NEAR(lens.print_dpi(), 508.0, 1e-10);
  EXPECT_NEAR(LensSheet(lens, 1000).sheet_width(), 50.0, 1e-12);
  const ExactPixels pixels = exact_pixels(asked, {.width = 50.0, .height = 30.0});
  EXPECT_NEAR(pixels.columns, 1000.0, 1e-9);
  EXPECT_NEAR(pixels.rows, 600.0, 1e-9);
  EXPECT_EQ(LensSheet(lens, 1000).views(), 0u);
}

TEST(UnitCameraSlantedSheet, DarkPixelsAreCounted) {
  LensParameters lens;
  lens.pitch = 6.0;
  lens.slant = 0.3;
  for (const LensModel model : {LensModel::kPinhole, LensModel::kParaxial}) {
    lens.model = model;
    const SlantedLenticular camera(lens, SheetPlacement{}, 60, 20);
    std::uint64_t dark = 0;
    Ray ray;
    for (int row = 0; row < 20; ++row) {
      for (int k = 0; k < 60; ++k) dark += camera.ray(k + 0.5, row + 0.5, ray) ? 0 : 1;
    }
    EXPECT_EQ(camera.dark_pixels(), dark);
    EXPECT_EQ(dark > 0, model == LensModel::kPinhole);
    EXPECT_EQ(camera.warnings().size(), dark > 0 ? 1u : 0u);
  }
}

TEST(UnitCameraSlantedSheet, TangentsOfTexts) {
  EXPECT_EQ(tangent_of_slant("1/6"), 1.0 / 6.0);
  EXPECT_EQ(tangent_of_slant("-1/3"), -1.0 / 3.0);
  EXPECT_EQ(tangent_of_slant("2/-5"), -0.4);
  EXPECT_EQ(tangent_of_slant("0"), 0.0);
  EXPECT_NEAR(*tangent_of_slant("45"), 1.0, 1e-15);
  EXPECT_NEAR(*tangent_of_slant("+9.4623"), 1.0 / 6.0, 1e-6);
  EXPECT_TRUE(tangent_of_slant("80"));
  for (const char* bad :
       {"", "nan", "inf", "90", "-90", "80.1", "1e300", "steep", "1/0", "/6", "1/", "1/2/3",
        "1/nan", "6/1", "1e300/1", "1e-300/1e300x", "9.46deg", "1:6"}) {
    EXPECT_FALSE(tangent_of_slant(bad)) << bad;
  }
}

TEST(ErrorCameraSlantedSheet, TooSteep) {
  LensRequest asked;
  asked.slant = 1e300;
  try {
    resolve(asked, 100, nullptr);
    FAIL();
  } catch (const CameraError& error) {
    EXPECT_STREQ(error.what(), "the slant of the lenses must be -80 to 80 degrees");
  }
}

}  // namespace
}  // namespace lentray::camera
