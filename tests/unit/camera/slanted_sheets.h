// Slanted sheets for tests: parameters, placements, and some of all models.
#pragma once

#include <cmath>

#include "camera/lens_sheet.h"
#include "camera/lenticular.h"
#include "tests/support/slanted_reference.h"

namespace lentray::camera {

inline LensParameters slanted_lens(const test::SlantReference& s) {
  LensParameters lens{s.pitch, s.focal_length, s.ior, s.pixels};
  if (s.distance > 0.0) lens.view_distance = s.distance;
  lens.model = s.model == test::SlantReference::Model::kParaxial  ? LensModel::kParaxial
               : s.model == test::SlantReference::Model::kPinhole ? LensModel::kPinhole
                                                                  : LensModel::kThick;
  lens.rays = static_cast<std::uint32_t>(s.rays);
  lens.slant = static_cast<double>(std::tan(s.angle()));
  return lens;
}

/// A turned sheet, `scale` scene units a mm to the right and `stretch` times as many upwards.
inline SheetPlacement slanted_placement(const test::SlantReference& s, double scale,
                                        double stretch) {
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

inline const test::SlantReference kSlantedSheets[] = {
    {.model = test::SlantReference::Model::kParaxial,
     .slant = 18.434948822922010648,
     .distance = 400.0},
    {.model = test::SlantReference::Model::kParaxial,
     .slant = -9.46,
     .pixels = 7.37,
     .distance = 250.0,
     .eye_slope_x = 0.2,
     .eye_slope_y = -0.1},
    {.model = test::SlantReference::Model::kParaxial,
     .slant = 30.0,
     .pixels = 5.5,
     .eye_slope_x = 0.1,
     .eye_slope_y = 0.25},
    {.model = test::SlantReference::Model::kPinhole, .slant = 18.434948822922010648},
    {.model = test::SlantReference::Model::kPinhole,
     .slant = -21.7,
     .pixels = 6.283,
     .distance = 300.0,
     .row_by_column = 2.0,
     .eye_slope_x = 0.15,
     .eye_slope_y = -0.2},
    {.model = test::SlantReference::Model::kPinhole,
     .slant = 60.0,
     .pixels = 9.1,
     .eye_slope_x = -0.2,
     .eye_slope_y = 0.1},
    {.model = test::SlantReference::Model::kThick, .slant = 18.434948822922010648, .rays = 5},
    {.model = test::SlantReference::Model::kThick,
     .slant = -12.0,
     .pixels = 6.6,
     .distance = 200.0,
     .row_by_column = 0.5,
     .eye_slope_x = 0.05,
     .eye_slope_y = 0.1,
     .rays = 4},
};

}  // namespace lentray::camera
