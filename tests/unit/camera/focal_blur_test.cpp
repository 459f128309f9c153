// Points of the aperture, places in the pixel, and when a sample has enough rays.
#include "core/render/focal_blur.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <utility>

#include "camera/blurred.h"
#include "camera/conversion.h"
#include "camera/lens_request.h"
#include "camera/projected.h"
#include "tests/unit/camera/plain_camera.h"

namespace lentray {
namespace {

using core::BlurEstimate;
using core::BlurRay;
using core::FocalBlur;
using core::FocalBlurOptions;
using core::Vec3;

double radius(const core::Vec2& p) { return std::hypot(p.u, p.v); }

// A table of chi-squared: with probability 0.9 it exceeds 0.0158, 4.168, 12.443 at 1, 9 and 20
// degrees of freedom, with probability 0.1 it exceeds 14.684 at 9.
TEST(UnitFocalBlur, ThresholdsAreThoseOfChiSquared) {
  const FocalBlur blur({.most = 10, .confidence = 0.9, .variance = 0.5});
  ASSERT_EQ(blur.stops().size(), 2u);  // 7 and 3 more
  EXPECT_EQ(blur.stops()[0].rays, 7);
  EXPECT_EQ(blur.stops()[1].rays, 10);
  EXPECT_NEAR(blur.stops()[0].threshold, 0.5 * 2.83311 / 4.16816, 1e-6);
  EXPECT_NEAR(blur.stops()[1].threshold, 0.5 * 4.86518 / 4.16816, 1e-6);
  const FocalBlur other({.most = 10, .confidence = 0.1, .variance = 0.5});
  EXPECT_NEAR(other.stops()[0].threshold, 0.5 * 12.0170 / 14.6837, 1e-5);
}

TEST(UnitFocalBlur, BatchesFollowTheLattices) {
  const auto rays = [](int most) {
    std::vector<int> out;
    const FocalBlur blur({.most = most});
    for (const auto& stop : blur.stops()) out.push_back(stop.rays);
    return out;
  };
  EXPECT_EQ(rays(1), (std::vector<int>{1}));
  EXPECT_EQ(rays(6), (std::vector<int>{4, 6}));
  EXPECT_EQ(rays(12), (std::vector<int>{7, 11, 12}));
  EXPECT_EQ(rays(20), (std::vector<int>{7, 13, 19, 20}));
  EXPECT_EQ(rays(42), (std::vector<int>{7, 13, 19, 23, 27, 31, 35, 37, 41, 42}));
}

TEST(UnitFocalBlur, PointsCoverTheDisc) {
  for (const int most : {1, 3, 4, 5, 7, 8, 18, 19, 20, 37, 38, 100, 1000}) {
    const FocalBlur blur({.most = most});
    ASSERT_EQ(blur.points().size(), static_cast<std::size_t>(most));
    double x = 0.0, y = 0.0, square = 0.0;
    for (const core::Vec2& p : blur.points()) {
      EXPECT_LE(radius(p), 0.5 + 1e-12) << most;
      x += p.u / most;
      y += p.v / most;
      square += radius(p) * radius(p) / most;
    }
    if (most == 4 || most >= 18) {
      EXPECT_NEAR(x, 0.0, 0.03) << most;
      EXPECT_NEAR(y, 0.0, 0.03) << most;
      EXPECT_NEAR(square, 0.125, 0.035) << most;  // R^2/2
    }
    const bool is_lattice = most == 7 || most == 19 || most == 37;
    if (!is_lattice) {
      EXPECT_NEAR(blur.jitter(), 0.5 / std::sqrt(most), 1e-12);
    }
  }
  // Lattices: no two points are nearer than their step, and jitter reaches half of it.
  for (const auto& [most, step] : {std::pair{7, 0.288675}, {19, 0.192450}, {37, 0.144338}}) {
    const FocalBlur blur({.most = most});
    EXPECT_NEAR(blur.jitter(), step / 2.0, 1e-6);
    for (std::size_t i = 0; i < blur.points().size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        const core::Vec2 &a = blur.points()[i], &b = blur.points()[k];
        EXPECT_GT(std::hypot(a.u - b.u, a.v - b.v), step - 1e-6);
      }
    }
  }
}

TEST(UnitFocalBlur, BokehWeighsPoints) {
  const FocalBlur half(
      {.most = 400, .weight = [](double x, double) { return x < 0.5 ? 0.0 : 1.0; }});
  ASSERT_EQ(half.points().size(), 400u);
  for (const core::Vec2& p : half.points()) EXPECT_GE(p.u, 0.0);
  const FocalBlur ramp({.most = 2000, .weight = [](double, double y) { return y; }});
  double y = 0.0;
  for (const core::Vec2& p : ramp.points()) y += p.v / 2000.0;
  EXPECT_NEAR(y, 2.0 / 3.0 - 0.5, 0.02);
  const FocalBlur black({.most = 9, .weight = [](double, double) { return 0.0; }});
  EXPECT_EQ(black.points().size(), 9u);
}

TEST(UnitFocalBlur, MoreRaysThanAnyPictureNeedsAreNotTaken) {
  const FocalBlur blur({.most = 2'000'000'000});
  EXPECT_EQ(blur.points().size(), static_cast<std::size_t>(FocalBlur::kMostRays));
}

/// Rays until the sample is done; the light of ray i is `light(i)`.
template <typename Light>
int rays_of(const FocalBlur& blur, Light light) {
  BlurEstimate estimate(blur, 7);
  int rays = 0;
  while (std::uint32_t more = estimate.more()) {
    for (; more > 0; --more) estimate.add({core::Rgb(static_cast<float>(light(rays++))), 0.0f});
  }
  return rays;
}

TEST(UnitFocalBlur, EndsWhereTheLightHardlyVaries) {
  const auto alike = [](int) { return 0.3; };
  const auto differs = [](int i) { return i % 2 ? 1.0 : 0.0; };
  EXPECT_EQ(rays_of(FocalBlur({.most = 100}), alike), 7);
  EXPECT_EQ(rays_of(FocalBlur({.most = 100}), differs), 100);
  EXPECT_EQ(rays_of(FocalBlur({.most = 100, .least = 20}), alike), 23);
  EXPECT_EQ(rays_of(FocalBlur({.most = 100, .variance = 0.0}), alike), 100);
  EXPECT_EQ(rays_of(FocalBlur({.most = 5}), alike), 4);
  EXPECT_EQ(rays_of(FocalBlur({.most = 1}), alike), 1);
  // V is 0.25/n; the threshold at n = 13 is 0.0254 for a variance of 0.1 and 50 rays.
  EXPECT_EQ(rays_of(FocalBlur({.most = 50, .variance = 0.1}), differs), 13);
}

TEST(UnitFocalBlur, PlacesFillThePixelEvenly) {
  const FocalBlur blur({.most = 256, .variance = 0.0});
  const BlurEstimate estimate(blur, 3);
  std::array<int, 16> cells{};
  for (std::uint32_t i = 0; i < 256; ++i) {
    const BlurRay ray = estimate.ray(i, i);
    ASSERT_LE(std::fabs(ray.across), 0.5);
    ASSERT_LE(std::fabs(ray.down), 0.5);
    const core::Vec2& point = blur.points()[i];
    ASSERT_LE(std::fabs(ray.x - point.u), blur.jitter());
    ASSERT_LE(std::fabs(ray.y - point.v), blur.jitter());
    ++cells[static_cast<std::size_t>(std::floor((ray.across + 0.5) * 4) * 4 +
                                     std::floor((ray.down + 0.5) * 4))];
  }
  for (const int count : cells) EXPECT_NEAR(count, 16, 3);
}

// Geometry: where rays through the aperture start and where they meet.

constexpr double kAperture = 0.8;

camera::BlurRequest request(double focal_distance) {
  camera::BlurRequest out;
  out.aperture = kAperture;
  out.focal_distance = focal_distance;
  out.samples.most = 10;
  return out;
}

/// All rays of a place pass one point at that depth, from starts that fill a disc of the aperture's
/// size at depth `from`.
void expect_meets(const camera::Camera& camera, const Vec3& middle, const Vec3& normal, double from,
                  double focus) {
  const core::PixelPlace place{.column = 2, .row = 5, .across = 0.2, .down = -0.3};
  const auto at_depth = [&](const core::Ray& ray, double depth) {
    return ray.at((depth - dot(ray.origin - middle, normal)) / dot(ray.direction, normal));
  };
  core::Ray centre, ray;
  ASSERT_TRUE(camera.ray_at(place, centre));
  for (const auto& [x, y] : {std::pair{0.0, 0.0}, {0.5, 0.0}, {0.0, 0.5}, {-0.3, 0.4}}) {
    ASSERT_TRUE(camera.lens_ray_at(place, x, y, ray));
    EXPECT_NEAR(length(ray.direction), 1.0, 1e-12);
    EXPECT_NEAR(length(at_depth(ray, focus) - at_depth(centre, focus)), 0.0, 1e-9);
    EXPECT_NEAR(length(at_depth(ray, from) - at_depth(centre, from)),
                0.5 * kAperture * std::hypot(x, y), 1e-9);
    EXPECT_NEAR(dot(ray.origin - centre.origin, normal), 0.0, 1e-9);
    EXPECT_GT(dot(ray.direction, centre.direction), 0.5);
  }
}

std::shared_ptr<const camera::Camera> projected(camera::ProjectedKind kind,
                                                const camera::Projection& p) {
  return std::make_shared<camera::Projected>(kind, p, camera::ProjectedAngles{120, 360, 180}, 16,
                                             12);
}

TEST(UnitThinLens, PerspectiveIsInFocusInAPlane) {
  const camera::Projection p = camera::plain_camera();
  const camera::Blurred camera(projected(camera::ProjectedKind::kPerspective, p),
                               camera::lens_of_camera(p, request(6.0)), {.most = 10});
  expect_meets(camera, p.location, {0, 0, 1}, 0.0, 6.0);
}

TEST(UnitThinLens, OrthographicIsInFocusInAPlane) {
  const camera::Projection p = camera::plain_camera();
  const camera::Blurred camera(projected(camera::ProjectedKind::kOrthographic, p),
                               camera::lens_of_camera(p, request(6.0)), {.most = 10});
  expect_meets(camera, p.location, {0, 0, 1}, 0.0, 6.0);
}

TEST(UnitThinLens, FisheyeIsInFocusOnASphere) {
  camera::Projection p = camera::plain_camera();
  p.direction = {0, 0, 1};
  const camera::Blurred camera(projected(camera::ProjectedKind::kFisheye, p),
                               camera::lens_of_camera(p, request(6.0)), {.most = 10});
  core::Ray centre, ray;
  const core::PixelPlace place{.column = 4, .row = 5};
  ASSERT_TRUE(camera.ray_at(place, centre));
  ASSERT_TRUE(camera.lens_ray_at(place, 0.3, -0.4, ray));
  const Vec3 meeting = centre.at(6.0);
  EXPECT_NEAR(length(cross(meeting - ray.origin, ray.direction)), 0.0, 1e-9);
  EXPECT_NEAR(length(ray.origin - p.location), 0.5 * 0.5 * kAperture, 1e-12);
}

TEST(UnitThinLens, SheetsAreInFocusWhereTheirCameraIs) {
  const camera::Projection p = camera::plain_camera();  // 10 units before the sheet
  for (const double view_distance : {0.0, 300.0}) {     // mm; 0: infinite
    for (const std::optional<double> front :
         {std::optional<double>(), std::optional<double>(2.0)}) {
      camera::Conversion conversion;
      conversion.lens.pixels = 8.0;
      conversion.lens.view_distance = view_distance;
      conversion.lens.front = front;
      const std::shared_ptr<camera::Lenticular> sheet =
          camera::sheet_of_camera("perspective", p, conversion, 64, 12, {}).camera;
      const camera::Blurred camera(sheet, camera::lens_of_conversion(*sheet, p, request(6.0)),
                                   {.most = 10});
      const double eyes = view_distance == 0.0 ? -10.0 : -sheet->eye_distance();
      expect_meets(camera, {1, 2, 0}, {0, 0, 1}, eyes, -4.0);
    }
  }
}

TEST(UnitThinLens, AStatedSheetIsInFocusAtItsFocalPoint) {
  camera::Projection p = camera::plain_camera();
  camera::LensRequest lens;
  lens.front = 3.0;
  const std::shared_ptr<camera::Lenticular> sheet =
      camera::sheet_of_statement(p, lens, 60, 12, {}).camera;
  camera::BlurRequest blur = request(1.0);
  expect_meets(camera::Blurred(sheet, camera::lens_of_statement(*sheet, blur), {.most = 10}),
               p.location, {0, 0, 1}, -3.0, 0.0);
  blur.focal_point = Vec3{7, 8, -11};  // a unit before the sheet
  expect_meets(camera::Blurred(sheet, camera::lens_of_statement(*sheet, blur), {.most = 10}),
               p.location, {0, 0, 1}, -3.0, -1.0);
  blur.focal_point = Vec3{7, 8, -14};  // before the plane that rays start in
  expect_meets(camera::Blurred(sheet, camera::lens_of_statement(*sheet, blur), {.most = 10}),
               p.location, {0, 0, 1}, -3.0, -4.0);
}

TEST(UnitThinLens, WhatHasNoLensIsRefused) {
  const camera::Projection p = camera::plain_camera();
  camera::BlurRequest blur = request(6.0);
  blur.aperture = INFINITY;
  EXPECT_THROW(camera::lens_of_camera(p, blur), camera::CameraError);
  EXPECT_THROW(camera::lens_of_camera(p, request(INFINITY)), camera::CameraError);
  const std::shared_ptr<camera::Lenticular> sheet =
      camera::sheet_of_statement(p, {}, 60, 12, {}).camera;
  blur = request(6.0);
  blur.focal_point = p.location - Vec3{0, 0, sheet->placement().front};
  EXPECT_THROW(camera::lens_of_statement(*sheet, blur), camera::CameraError);
}

}  // namespace
}  // namespace lentray
