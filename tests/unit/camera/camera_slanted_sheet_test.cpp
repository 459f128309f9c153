// Slanted sheets: rays of all models against vectors refracted in long double, and that a slant of 0 is
// the upright sheet.
#include "camera/slanted_sheet.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "camera/slanted_lenticular.h"
#include "camera/thick_lenticular.h"
#include "tests/unit/camera/place_ray.h"
#include "tests/unit/camera/slanted_sheets.h"

namespace lentray::camera {
namespace {

using core::Ray;
using core::Vec3;
using test::SlantReal;
using test::SlantReference;
using Model = SlantReference::Model;

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
      for (int row = 0; row < s.rows; row += 7) {
        for (int column = 0; column < s.columns; ++column) {
          for (int j = 0; j < s.rays; ++j) {
            const auto want = slant_ray(s, column, row, j);
            Ray got;
            const bool shows = test::place_ray(camera, {.column = column, .row = row},
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
      EXPECT_GT(lit, s.columns * s.rows / 8);
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

}  // namespace
}  // namespace lentray::camera
