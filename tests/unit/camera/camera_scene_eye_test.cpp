// Rays of sheets whose scene is seen by an eye of its own: each is worked out here from the light that the
// same sheet sends to its viewer, which the rays of the sheet without such an eye have.
#include "camera/scene_eye.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "camera/slanted_lenticular.h"
#include "camera/thick_lenticular.h"
#include "camera/view_cameras.h"

namespace lentray::camera {
namespace {

using core::Vec3;

constexpr double kEyeScale = 0.01;  // scene units a mm
constexpr std::uint32_t kEyeColumns = 121, kEyeRows = 40;

SheetPlacement scene_eye_place() {
  SheetPlacement place;
  place.centre = {1.3, -0.7, 2.1};
  place.right = {2.0 / 3.0, 1.0 / 3.0, -2.0 / 3.0};
  place.up = {-2.0 / 3.0, 2.0 / 3.0, -1.0 / 3.0};
  place.normal = {1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0};
  return place;
}

std::unique_ptr<Lenticular> scene_eye_sheet(const LensParameters& lens, SheetPlacement place) {
  place.width = kEyeColumns / lens.pixels * lens.pitch / lens.slant_cosine() * kEyeScale;
  place.height = 0.4 * place.width;
  if (lens.slant != 0.0)
    return std::make_unique<SlantedLenticular>(lens, place, kEyeColumns, kEyeRows);
  if (lens.model == LensModel::kThick)
    return std::make_unique<ThickLenticular>(lens, place, kEyeColumns, kEyeRows);
  return std::make_unique<Lenticular>(lens, place, kEyeColumns, kEyeRows);
}

/// A ray where it passes the sheet's plane: mm beside its middle, and slopes against the normal.
struct PassingRay {
  double x = 0.0, y = 0.0, slope_x = 0.0, slope_y = 0.0;
};

PassingRay where_it_passes(const Lenticular& sheet, const core::Ray& ray) {
  const SheetPlacement& p = sheet.placement();
  const double ahead = core::dot(ray.direction, p.normal);
  const Vec3 from = ray.origin - p.centre;
  const double t = -core::dot(from, p.normal) / ahead;
  const Vec3 there = from + ray.direction * t;
  return {core::dot(there, p.right) / kEyeScale, core::dot(there, p.up) / kEyeScale,
          core::dot(ray.direction, p.right) / ahead, core::dot(ray.direction, p.up) / ahead};
}

struct SceneEyeCase {
  LensParameters lens;
  double distance;  ///< D, scene units
  double factor;
  double slope_x, slope_y;  ///< of the scene's eye
};

std::vector<SceneEyeCase> scene_eye_cases() {
  std::vector<SceneEyeCase> out;
  for (const LensModel model : {LensModel::kParaxial, LensModel::kPinhole, LensModel::kThick}) {
    for (const double slant : {0.0, 1.0 / 3.0}) {
      for (const double viewer : {400.0, LensParameters::kInfinity}) {
        for (const double eye : {2.5, 11.0, LensParameters::kInfinity}) {
          LensParameters lens;
          lens.model = model;
          lens.slant = slant;
          lens.view_distance = viewer;
          lens.pixels = slant == 0.0 ? 12.4 : 11.0;
          lens.rays = 5;
          out.push_back({lens, eye, 0.3, std::isinf(eye) ? 0.0 : 0.2, -0.1});
        }
      }
    }
  }
  return out;
}

TEST(UnitCameraSceneEye, LightOfTheViewersEyesIsThatOfTheScenesEyes) {
  std::size_t rays = 0;
  for (const SceneEyeCase& c : scene_eye_cases()) {
    const auto viewers = scene_eye_sheet(c.lens, scene_eye_place());
    SheetPlacement place = scene_eye_place();
    place.eye = SceneEye{c.distance, c.factor};
    place.eye_slope_x = c.slope_x;
    place.eye_slope_y = c.slope_y;
    place.front = std::isinf(c.distance) ? 1.0 : c.distance;
    const auto scenes = scene_eye_sheet(c.lens, place);
    const double v = c.lens.view_distance, d = c.distance / kEyeScale;
    for (std::int32_t row = 0; row < static_cast<std::int32_t>(kEyeRows); row += 13) {
      for (std::int32_t k = 0; k < static_cast<std::int32_t>(kEyeColumns); ++k) {
        const core::PixelPlace at{.column = k, .row = row};
        for (std::uint32_t j = 0; j < viewers->rays_a_place(); ++j) {
          core::Ray light, middle, scene;
          const core::PlaceRay which{j, {(j + 0.5) / viewers->rays_a_place() - 0.5, 0.0}};
          const bool is_lit = viewers->one_ray_at(at, which, light);
          ASSERT_EQ(scenes->one_ray_at(at, which, scene), is_lit);
          if (!is_lit || !viewers->ray_at(at, middle)) continue;
          const PassingRay out = where_it_passes(*viewers, light),
                           vertex = where_it_passes(*viewers, middle),
                           is = where_it_passes(*scenes, scene);
          // How far beside the viewer's eye the light passes its plane, a mm of V; V infinite: a slope.
          const auto beside = [&](const PassingRay& r) { return r.x / v - r.slope_x; };
          const double eye =
              c.factor * beside(vertex) + (beside(out) - beside(vertex));  // a mm of D
          const bool is_thick = c.lens.model == LensModel::kThick;
          // A thick lens's middle ray is that of a level row, and its light leaves the bulge up to 0.3 mm behind
          // the sheet's plane.
          EXPECT_NEAR(is.x, out.x, is_thick ? 0.06 : 1e-9);
          EXPECT_NEAR(is.slope_x, is.x / d - eye + c.slope_x, is_thick ? 3e-3 : 1e-11);
          EXPECT_NEAR(is.slope_y, is.y / d + c.slope_y, is_thick ? 1e-4 : 1e-11);
          ++rays;
        }
      }
    }
  }
  EXPECT_GT(rays, 30'000u);
}

TEST(UnitCameraSceneEye, WithoutOneAndWithTheViewersPlaceAndAllDepthRaysAreTheSame) {
  for (const LensModel model : {LensModel::kParaxial, LensModel::kPinhole, LensModel::kThick}) {
    LensParameters lens;
    lens.model = model;
    lens.view_distance = 300.0;
    const auto plain = scene_eye_sheet(lens, scene_eye_place());
    SheetPlacement place = scene_eye_place();
    place.eye = SceneEye{300.0 * kEyeScale, 1.0};
    const auto scenes = scene_eye_sheet(lens, place);
    EXPECT_NEAR(scenes->eye_distance(), plain->eye_distance(), 1e-12);
    for (std::uint32_t k = 0; k < kEyeColumns; ++k) {
      core::Ray a, b;
      if (!plain->ray(k + 0.5, 3.5, a)) continue;
      ASSERT_TRUE(scenes->ray(k + 0.5, 3.5, b));
      EXPECT_LT(core::length(a.direction - b.direction), 1e-12);
      EXPECT_LT(core::length(a.origin - b.origin), 1e-12);
    }
  }
}

// The middle view is the scene's own picture, and the others are seen from beside its eye.
TEST(UnitCameraSceneEye, ViewsArePerspectivesOfTheScenesEyes) {
  LensParameters lens;
  lens.model = LensModel::kParaxial;
  lens.view_distance = 400.0;
  lens.pixels = 11.0;
  SheetPlacement place = scene_eye_place();
  place.eye = SceneEye{3.7, 0.25};
  place.eye_slope_x = 0.1;
  place.front = 3.7;
  const auto sheet = scene_eye_sheet(lens, place);
  const Vec3 own = place.centre - (place.normal + place.right * 0.1) * 3.7;
  for (std::uint32_t j = 0; j < 11; ++j) {
    const SheetView view(*sheet, j);
    const ViewCamera camera = view_camera(*sheet, view, view.width());
    EXPECT_TRUE(camera.is_perspective);
    EXPECT_LT(camera.miss, 1e-12);
    const double e = ((j + 0.5) / 11.0 - 0.5) * lens.print_pitch();
    const double beside = -0.25 * 3.7 * lens.ior * e / lens.focal_length;
    EXPECT_LT(core::length(camera.eye - own - place.right * beside), 1e-11) << j;
  }
}

}  // namespace
}  // namespace lentray::camera
