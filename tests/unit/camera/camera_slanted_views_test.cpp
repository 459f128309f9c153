// Slanted sheets: which pixel is whose, views, sizes, and the texts of slants.
#include <gtest/gtest.h>

#include <cmath>

#include "camera/lens_request.h"
#include "camera/sheet_views.h"
#include "camera/slanted_lenticular.h"
#include "tests/unit/camera/slanted_sheets.h"

namespace lentray::camera {
namespace {

using core::Ray;
using core::Vec3;
using test::SlantReference;

/// By hand: tan a = 1/3 and square pixels, N = 6. From one row to the next the strips go on by a third
/// of a column. The tops lean to the right.
TEST(UnitCameraSlantedViews, StripsLeanToTheRight) {
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
TEST(UnitCameraSlantedViews, AViewsPixelIsTheNearest) {
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
TEST(UnitCameraSlantedViews, PicturesOfViewsAreWhole) {
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

TEST(UnitCameraSlantedViews, SizesAndResolution) {
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

TEST(UnitCameraSlantedViews, DarkPixelsAreCounted) {
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

TEST(UnitCameraSlantedViews, TangentsOfTexts) {
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

TEST(ErrorCameraSlantedViews, TooSteep) {
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
