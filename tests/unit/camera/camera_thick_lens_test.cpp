// Rays of the thick lens against an independent trace: vectors in space and in long double, from the
// print through the cylinders, each of which is searched for by itself.
#include "camera/thick_lens.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "camera/lens_request.h"
#include "camera/thick_lenticular.h"
#include "camera/thin_lens.h"
#include "tests/support/thick_places.h"
#include "tests/unit/camera/place_ray.h"

namespace lentray::camera::thick_test {
namespace {

using core::Ray;
using core::Vec3;

constexpr double kInf = LensParameters::kInfinity;

using Real = long double;
using Triple = std::array<Real, 3>;

Real dot(const Triple& a, const Triple& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Triple scaled(const Triple& a, Real by) { return {a[0] * by, a[1] * by, a[2] * by}; }
Triple sum(const Triple& a, const Triple& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Triple unit(const Triple& a) { return scaled(a, 1.0L / std::sqrt(dot(a, a))); }

struct ThickExpected {
  Real across = 0.0L, depth = 0.0L, slope = 0.0L, rise = 0.0L;
  Real least_cosine = 1.0L;  ///< of the angles in the air, whose inverse magnifies rounding
  int lenses = 1;
};

/// A sheet of cylinders along y; the light goes towards negative z.
class Glass {
 public:
  explicit Glass(const LensParameters& lens)
      : m_pitch(lens.pitch), m_focal(lens.focal_length), m_ior(lens.ior),
        m_radius(m_focal * (m_ior - 1.0L) / m_ior) {}

  /// From the print at `offset` towards the surface at `across` and up by `climb`. Nothing: dark.
  std::optional<ThickExpected> from_print(Real offset, Real across, Real climb) const {
    const Real depth = m_radius - std::sqrt(m_radius * m_radius - across * across);
    Triple place{offset, 0.0L, m_focal}, way = unit({across - offset, climb, depth - m_focal});
    ThickExpected out;
    bool in_glass = true;
    for (int step = 0; step < 100; ++step) {
      Real lens = 0.0L;
      const Real distance = next_surface(place, way, in_glass, lens);
      if (in_glass && way[2] > 0.0L && (m_focal - place[2]) / way[2] < distance) return {};
      if (!std::isfinite(distance)) {
        if (in_glass || way[2] >= 0.0L) return {};
        out.across = place[0];
        out.depth = place[2];
        out.slope = way[0] / way[2];
        out.rise = way[1] / way[2];
        return out;
      }
      place = sum(place, scaled(way, distance));
      if (step == 0 && std::fabs(place[0] - across) > 1e-15L * m_radius)
        return {};  // not its point
      if (!cross(place, lens, in_glass, way, out)) return {};
      if (in_glass) ++out.lenses;
    }
    return {};
  }

 private:
  /// To the nearest arc, infinite if there is none; and the axis of its lens.
  Real next_surface(const Triple& place, const Triple& way, bool in_glass, Real& lens) const {
    Real nearest = INFINITY;
    const Real flat = way[0] * way[0] + way[2] * way[2];
    const Real here = std::round(place[0] / m_pitch);
    for (int i = -8; i <= 8; ++i) {
      const Real axis = (here + i) * m_pitch;
      const Real x = place[0] - axis, z = place[2] - m_radius;
      const Real b = (x * way[0] + z * way[2]) / flat;
      const Real c = (x * x + z * z - m_radius * m_radius) / flat;
      if (b * b < c) continue;
      const Real root = std::sqrt(b * b - c);
      const Real distance = in_glass ? root - b : -root - b;  // the far side, or the near one
      const Real at = x + distance * way[0];
      const bool on_arc = std::fabs(at) <= 0.5L * m_pitch && z + distance * way[2] < 0.0L;
      if (on_arc && distance > 1e-14L * m_radius && distance < nearest) {
        nearest = distance;
        lens = axis;
      }
    }
    return nearest;
  }

  /// Refraction at a surface, or total reflection.
  bool cross(const Triple& place, Real lens, bool& in_glass, Triple& way,
             ThickExpected& out) const {
    const Triple outwards{(place[0] - lens) / m_radius, 0.0L, (place[2] - m_radius) / m_radius};
    const Triple normal = in_glass ? outwards : scaled(outwards, -1.0L);
    const Real ratio = in_glass ? m_ior : 1.0L / m_ior;
    const Real cosine = dot(way, normal);
    const Triple along = scaled(sum(way, scaled(normal, -cosine)), ratio);
    const Real left = 1.0L - dot(along, along);
    if (left <= 0.0L) {
      way = sum(way, scaled(normal, -2.0L * cosine));
      return true;
    }
    way = sum(along, scaled(normal, std::sqrt(left)));
    out.least_cosine = std::min(out.least_cosine, in_glass ? std::sqrt(left) : cosine);
    in_glass = !in_glass;
    return true;
  }

  Real m_pitch, m_focal, m_ior, m_radius;
};

/// The rays that rise by `rise` outside, found by their climb in the glass, in parts of its range.
std::vector<ThickExpected> expected_rays(const LensParameters& lens, double offset, double across,
                                         double rise, int parts) {
  const Glass glass(lens);
  std::vector<ThickExpected> out;
  const auto add = [&](const std::optional<ThickExpected>& ray) {
    if (ray && std::fabs(ray->rise - rise) <= 1e-14L / ray->least_cosine) out.push_back(*ray);
  };
  if (rise == 0.0) {
    add(glass.from_print(offset, across, 0.0L));
    return out;
  }
  enum State { kLess, kMore, kDark };
  std::optional<ThickExpected> ray;
  const auto state_at = [&](Real climb) {
    ray = glass.from_print(offset, across, climb);
    if (!ray) return kDark;
    return std::fabs(ray->rise) <= std::fabs(rise) ? kLess : kMore;
  };
  const Real step = std::copysign(2.0L * lens.focal_length / parts, -rise);
  State last = state_at(0.0L);
  for (int i = 1; i <= parts; ++i) {
    const State now = state_at(i * step);
    if (now != last && last != kMore && now != kLess) {
      Real least = (i - 1) * step, most = i * step;
      for (int half = 0; half < 70; ++half) {
        const Real middle = 0.5L * (least + most);
        (state_at(middle) == last ? least : most) = middle;
      }
      state_at(last == kDark ? most : least);
      add(ray);
    }
    last = now;
  }
  return out;
}

LensParameters thick(double pitch, double focal, double ior, std::uint32_t rays = 16,
                     double distance = kInf, double pixels = 15.0) {
  LensParameters lens{pitch, focal, ior, pixels, distance, LensModel::kThick};
  lens.rays = rays;
  return lens;
}

struct Tally {
  int straight = 0, spilled = 0, returned = 0, reflected = 0, hidden = 0;
  double largest = 0.0;
};

/// Places in mm; slopes as angles. Of rays that graze a surface, less.
double difference(const SheetExit& got, const ThickExpected& want) {
  const Real scale = std::max(1.0L, want.slope * want.slope);
  return static_cast<double>(
      std::max({std::fabs(got.across - want.across), std::fabs(got.depth - want.depth),
                std::fabs(got.slope - want.slope) / scale}));
}

/// The middles of all parts of the aperture, offsets in 32nds of the pitch, and several slopes along the lens.
Tally compare(const LensParameters& parameters, int first = -45, int last = 45) {
  const ThickLens lens(parameters);
  Tally tally;
  for (const double rise : {0.0, 0.11, -0.3, 0.8}) {
    for (int k = first; k <= last; ++k) {
      const double offset = k / 32.0 * parameters.pitch;
      for (std::uint32_t j = 0; j < lens.rays(); ++j) {
        const double across = ((j + 0.5) / lens.rays() - 0.5) * parameters.pitch;
        SheetExit got;
        const LensRayEnd end = lens.leave(offset, across, {rise}, got);
        const std::string where = "offset " + std::to_string(offset) + " point " +
                                  std::to_string(j) + " rise " + std::to_string(rise);
        if (!shows(end)) {
          ++(end == LensRayEnd::kReturns     ? tally.returned
             : end == LensRayEnd::kReflected ? tally.reflected
                                             : tally.hidden);
          for (const ThickExpected& want : expected_rays(parameters, offset, across, rise, 48)) {
            ADD_FAILURE() << where << " has a ray, slope " << want.slope;
          }
          continue;
        }
        ++(end == LensRayEnd::kLeaves ? tally.straight : tally.spilled);
        double error = kInf;
        for (const int parts : {48, 3000}) {  // some shine through a narrow gap
          if (error < 1.0) break;
          for (const ThickExpected& want : expected_rays(parameters, offset, across, rise, parts)) {
            const bool same_end = (end == LensRayEnd::kLeaves) == (want.lenses == 1);
            if (same_end) error = std::min(error, difference(got, want));
          }
        }
        EXPECT_LT(error, 1e-12) << where << " slope " << got.slope;
        tally.largest = std::max(tally.largest, error);
      }
    }
  }
  ::testing::Test::RecordProperty("largest", std::to_string(tally.largest * 1e15) + "e-15");
  return tally;
}

TEST(UnitCameraThickLens, ThePapersLens) {
  const Tally tally = compare(thick(1.124, 3.03, 1.6));
  EXPECT_GT(tally.straight, 5000);
  EXPECT_GT(tally.reflected, 50);
}

TEST(UnitCameraThickLens, OfSixtyLensesAnInch) {
  const Tally tally = compare(thick(25.4 / 60.0, 0.7, 1.57));
  EXPECT_GT(tally.straight, 4000);
  EXPECT_GT(tally.reflected, 500);
}

TEST(UnitCameraThickLens, WideOnesLoseLightInTheNextLens) {
  const Tally tally = compare(thick(2.2, 3.03, 1.6));
  EXPECT_GT(tally.straight, 3000);
  EXPECT_GT(tally.returned, 80);
  EXPECT_GT(tally.hidden, 100);
  EXPECT_GT(tally.reflected, 100);
}

TEST(UnitCameraThickLens, LightPassesThroughTheNextLens) {
  EXPECT_GT(compare(thick(0.923, 2.0, 1.3, 65), 32, 45).spilled, 20);
  EXPECT_GT(compare(thick(1.1428, 2.0, 1.4, 129), -36, -26).spilled, 20);
}

TEST(UnitCameraThickLens, IsParaxialNearTheAxis) {
  // Errors of slopes are of third order in P/f.
  for (const double pitch : {1e-2, 1e-3}) {
    const LensParameters parameters = thick(pitch, 2.0, 1.5, 5);
    const ThickLens lens(parameters);
    for (const double cells : {-0.5, -0.1, 0.3}) {
      for (std::uint32_t j = 0; j < 5; ++j) {
        SheetExit exit;
        ASSERT_EQ(lens.leave(cells * pitch, lens.middle(j), {0.0}, exit), LensRayEnd::kLeaves);
        EXPECT_NEAR(exit.slope, 1.5 * cells * pitch / 2.0, 2.0 * std::pow(pitch / 2.0, 3));
      }
    }
  }
}

TEST(UnitCameraThickLens, ThroughTheVertexItIsAPinhole) {
  LensParameters parameters = thick(1.124, 3.03, 1.6);
  const ThickLens lens(parameters);
  parameters.model = LensModel::kPinhole;
  for (const double offset : {-0.5, -0.1, 0.0, 0.3, 0.56}) {
    SheetExit exit;
    double slope = 0.0;
    ASSERT_TRUE(slope_of(parameters, offset, slope));
    ASSERT_EQ(lens.leave(offset, 0.0, {0.0}, exit), LensRayEnd::kLeaves);
    EXPECT_NEAR(exit.slope, slope, 1e-15);
    EXPECT_EQ(exit.depth, 0.0);
  }
}

SheetPlacement turned_sheet(double width, double height, double front) {
  SheetPlacement place;
  const double c = std::cos(0.4), s = std::sin(0.4);
  place.right = {c, 0.0, s};
  place.normal = {-s, 0.0, c};
  place.centre = {1.0, -2.0, 0.5};
  place.width = width;
  place.height = height;
  place.front = front;
  place.eye_slope_x = 0.05;
  place.eye_slope_y = -0.1;
  return place;
}

/// Every ray of a sheet, that goes through the lens and column that it belongs to, at its own place of both.
TEST(UnitCameraThickLenticular, PlacesItsRays) {
  for (const LensParameters& lens :
       {thick(1.124, 3.03, 1.6), thick(1.124, 3.03, 1.6, 7, 60.0, 12.4),
        thick(2.2, 3.03, 1.6, 9)}) {
    const SheetPlacement place = turned_sheet(5.0, 3.0, 2.0);
    const ThickLenticular camera(lens, place, 45, 6);
    const ThickLens optics(lens);
    EXPECT_EQ(camera.rays_a_place(), lens.rays);
    for (std::int32_t row = 0; row < 6; ++row) {
      int first = 0;  // column of the lens
      for (std::int32_t k = 0; k < 45; ++k) {
        const LensColumn& column = camera.sheet().column(static_cast<std::uint32_t>(k));
        const double own = std::floor((k + 0.5) / lens.pixels);
        if (std::floor((k - 0.5) / lens.pixels) < own) first = k;
        for (std::uint32_t j = 0; j < lens.rays; ++j) {
          const auto at = test::thick_place(static_cast<std::int64_t>(own), row, k - first,
                                            static_cast<int>(j), static_cast<int>(lens.rays));
          const double across = static_cast<double>(at.part - 0.5L) * lens.pitch;
          const double y = (0.5 - (row + 0.5 + static_cast<double>(at.down)) / 6.0) * 3.0;
          const double rise = y / (lens.view_distance * camera.scale()) - 0.1;
          SheetExit exit;
          Ray ray;
          const bool lit = shows(optics.leave(column.lens_offset, across, {rise}, exit));
          ASSERT_EQ(test::place_ray(camera, {.column = k, .row = row}, j, ray), lit);
          if (!lit) continue;
          // Along the ray from its start to where it leaves the sheet.
          const double way = (2.0 + exit.depth * camera.scale()) / dot(ray.direction, place.normal);
          const Vec3 leaves = ray.at(way) - place.centre;
          EXPECT_NEAR(dot(leaves, place.right), (column.axis + exit.across) * camera.scale(),
                      1e-12);
          EXPECT_NEAR(dot(leaves, place.up), y, 1e-12);
          EXPECT_NEAR(dot(leaves, place.normal), exit.depth * camera.scale(), 1e-12);
          const double deep = dot(ray.direction, place.normal);
          EXPECT_NEAR(dot(ray.direction, place.right) / deep, exit.slope, 1e-12);
          EXPECT_NEAR(dot(ray.direction, place.up) / deep, rise, 1e-12);
          EXPECT_NEAR(dot(ray.direction, ray.direction), 1.0, 1e-15);
        }
      }
    }
  }
}

TEST(UnitCameraThickLenticular, OneRayIsThatThroughTheVertex) {
  const ThickLenticular camera(thick(1.124, 3.03, 1.6, 1, 60.0), turned_sheet(5.0, 3.0, 2.0), 45,
                               6);
  for (std::int32_t k = 0; k < 45; ++k) {
    Ray whole, place, one;
    ASSERT_TRUE(camera.ray(k + 0.5, 4.5, whole));
    ASSERT_TRUE(camera.ray_at({.column = k, .row = 4}, place));
    ASSERT_TRUE(camera.one_ray_at({.column = k, .row = 4}, {}, one));
    EXPECT_EQ(whole.origin, place.origin);
    EXPECT_EQ(whole.direction, place.direction);
    EXPECT_EQ(whole.origin, one.origin);
    EXPECT_EQ(whole.direction, one.direction);
    Ray sight;
    ASSERT_TRUE(camera.sight({.column = k, .row = 4}, sight));
    EXPECT_NEAR(dot(sight.direction, camera.placement().normal), 1.0, 1e-15);
    EXPECT_LT(length(sight.origin - sight.direction * 2.0 - whole.origin), 1e-14);
  }
}

/// Areas of pixels: neighbours of a view, and of a lens, join.
TEST(UnitCameraThickLenticular, PlacesJoin) {
  const ThickLenticular camera(thick(1.124, 3.03, 1.6, 6, 60.0), turned_sheet(5.0, 3.0, 2.0), 45,
                               6);
  const auto expect_same = [&](const core::PixelPlace& a, const core::PixelPlace& b) {
    for (std::uint32_t j = 0; j < 6; ++j) {
      const core::PlaceRay which = camera.ray_of({1, 2, 3}, j);
      Ray left, right;
      ASSERT_TRUE(camera.one_ray_at(a, which, left));
      ASSERT_TRUE(camera.one_ray_at(b, which, right));
      EXPECT_LT(length(left.origin - right.origin), 1e-13);
      EXPECT_LT(length(left.direction - right.direction), 1e-13);
    }
  };
  for (std::int32_t k = 15; k < 29; ++k) {
    expect_same({.column = k, .row = 2, .across = 0.5, .turn = 0.2},
                {.column = k + 15, .row = 2, .across = -0.5, .turn = 0.2});
    expect_same({.column = k, .row = 2, .across = 0.1, .down = 0.5},
                {.column = k, .row = 3, .across = 0.1, .down = -0.5});
    expect_same({.column = k, .row = 2, .across = 0.3, .turn = 0.5},
                {.column = k + 1, .row = 2, .across = 0.3, .turn = -0.5});
  }
}

TEST(UnitCameraThickLenticular, AViewShowsItsColumnsOfTheSheet) {
  const ThickLenticular camera(thick(1.124, 3.03, 1.6, 6, 60.0), turned_sheet(5.0, 3.0, 2.0), 45,
                               6);
  const SheetView view(camera, 4);
  EXPECT_EQ(view.rays_a_place(), 6u);
  EXPECT_TRUE(view.missing_rays_are_black());
  for (std::int32_t lens = 0; lens < 3; ++lens) {
    for (std::uint32_t j = 0; j < 6; ++j) {
      Ray of_view, of_sheet;
      ASSERT_TRUE(test::place_ray(view, {.column = lens, .row = 3}, j, of_view));
      ASSERT_TRUE(test::place_ray(camera, {.column = 15 * lens + 4, .row = 3}, j, of_sheet));
      EXPECT_EQ(of_view.origin, of_sheet.origin);
      EXPECT_EQ(of_view.direction, of_sheet.direction);
    }
  }
}

/// An eye before the sheet's middle, so near that the outer strips of the print lie far beside their lenses.
TEST(UnitCameraThickLenticular, CountsWhatShowsNothing) {
  std::uint64_t all_dark = 0;
  for (const double distance : {kInf, 9.0, 2.5}) {
    const LensParameters lens = thick(2.2, 3.03, 1.6, 3, distance, 9.0);
    const ThickLenticular camera(lens, turned_sheet(16.0, 12.0, 0.5), 63, 20);
    std::uint64_t dark_pixels = 0;
    for (std::int32_t row = 0; row < 20; ++row) {
      for (std::int32_t k = 0; k < 63; ++k) {
        int lit = 0;
        Ray ray;
        for (std::uint32_t j = 0; j < 3; ++j) {
          const core::PlaceRay middle{j, {(j + 0.5) / 3.0 - 0.5, 0.0}};
          lit += camera.one_ray_at({.column = k, .row = row}, middle, ray) ? 1 : 0;
        }
        if (lit == 0) ++dark_pixels;
      }
    }
    EXPECT_EQ(camera.dark_pixels(), dark_pixels);
    all_dark += dark_pixels;
    int spilled = 0, dark_rays = 0;
    const ThickLens optics(lens);
    for (std::uint32_t k = 0; k < 63; ++k) {
      for (std::uint32_t j = 0; j < 3; ++j) {
        SheetExit exit;
        const LensRayEnd end = optics.leave(camera.sheet().column(k).lens_offset, optics.middle(j),
                                            {camera.rise(10.0)}, exit);
        spilled += end == LensRayEnd::kSpills || end == LensRayEnd::kReturns ? 1 : 0;
        dark_rays += shows(end) ? 0 : 1;
      }
    }
    EXPECT_EQ(camera.shares().spilled, spilled / 189.0);
    EXPECT_EQ(camera.shares().dark, dark_rays / 189.0);
    EXPECT_GT(dark_rays, 0);
    const std::vector<std::string> warnings = camera.warnings();
    ASSERT_EQ(warnings.empty(), dark_pixels == 0);
    if (dark_pixels == 0) continue;
    EXPECT_EQ(warnings.back(),
              std::to_string(dark_pixels) +
                  " pixels show nothing, for none of their rays leaves the sheet: "
                  "they are totally reflected inside it, or come back to the print");
  }
  EXPECT_GT(all_dark, 100u);
}

TEST(UnitCameraThickLenticular, ReportsItsRays) {
  const ThickLenticular camera(thick(2.2, 3.03, 1.6, 8), SheetPlacement{}, 45, 6);
  const std::vector<std::string> report = camera.model_report();
  ASSERT_EQ(report.size(), 1u);
  EXPECT_EQ(
      report[0],
      "Each pixel is the mean of 8 rays; of those, 0 % spill into the next lens, and 15 % show "
      "nothing (middle row)");
  const Properties properties = camera.describe();
  const auto value = [&](const std::string& key) {
    for (const auto& [name, what] : properties) {
      if (name == key) return what;
    }
    return Properties::value_type::second_type{};
  };
  EXPECT_EQ(std::get<std::string>(value("lens.model")), "thick");
  EXPECT_EQ(std::get<double>(value("lens.rays")), 8.0);
  EXPECT_EQ(std::get<double>(value("lens.spilled_rays")), camera.shares().spilled);
  EXPECT_EQ(std::get<double>(value("lens.dark_rays")), camera.shares().dark);
}

TEST(ErrorCameraThickLens, HasNoFocalBlur) {
  const ThickLenticular camera(thick(1.124, 3.03, 1.6), SheetPlacement{}, 45, 6);
  BlurRequest blur;
  blur.aperture = 0.4;
  try {
    (void)lens_of_statement(camera, blur);
    FAIL() << "no error";
  } catch (const CameraError& error) {
    EXPECT_STREQ(
        error.what(),
        "the lens model thick has no focal blur: leave out the aperture, or take the model "
        "paraxial or pinhole");
  }
}

TEST(ErrorCameraThickLens, NoSuchLens) {
  EXPECT_EQ(complaint(thick(1.124, 3.03, 1.6)), "");
  EXPECT_EQ(complaint(thick(2.28, 3.04, 1.6)), "");
  EXPECT_EQ(complaint(thick(2.4, 3.03, 1.6)),
            "there is no such lens: its surface would have a radius of 1.13625 mm, f (n - 1)/n, so "
            "it can be 2.2725 mm wide at most, not 2.4 mm");
  EXPECT_NE(complaint(thick(1.0, 3.0, 1.0)).find("a radius of 0 mm"), std::string::npos);
  EXPECT_EQ(complaint(thick(1.0, 3.0, 1.6, 0)), "the rays of a lens must be 1 to 1024");
  EXPECT_EQ(complaint(thick(1.0, 3.0, 1.6, 1025)), "the rays of a lens must be 1 to 1024");
  LensParameters pinhole = thick(2.4, 3.03, 1.6);
  pinhole.model = LensModel::kPinhole;
  EXPECT_EQ(complaint(pinhole), "");
}

}  // namespace
}  // namespace lentray::camera::thick_test
