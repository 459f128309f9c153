// Scenes of balls and walls for tests of depth, and their sheets.
#pragma once

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "camera/conversion.h"
#include "tests/unit/camera/plain_camera.h"

namespace lentray::camera {

struct DepthBall {
  core::Vec3 centre;
  double radius;
  const char* name;
};

/// Balls, and perhaps a wall z = const.
inline SceneProbe depth_scene(std::vector<DepthBall> balls, std::optional<double> wall = {}) {
  return [balls = std::move(balls), wall](const core::Ray& ray, double limit) {
    std::optional<ProbeHit> out;
    const auto take = [&](double t, const char* name) {
      if (t > 1e-9 && t < limit && (!out || t < out->distance)) out = ProbeHit{t, name, name};
    };
    for (const DepthBall& ball : balls) {
      const core::Vec3 o = ray.origin - ball.centre;
      const double a = core::length_squared(ray.direction), b = core::dot(o, ray.direction);
      const double under = b * b - a * (core::length_squared(o) - ball.radius * ball.radius);
      if (under < 0.0) continue;
      take((-b - std::sqrt(under)) / a, ball.name);
      take((-b + std::sqrt(under)) / a, ball.name);
    }
    if (wall && ray.direction.z != 0.0) take((*wall - ray.origin.z) / ray.direction.z, "plane");
    return out;
  };
}

inline Sheet depth_sheet(const SceneProbe& probe, const Conversion& conversion = {},
                         std::uint32_t width = 640, std::uint32_t height = 480) {
  return sheet_of_camera("perspective", plain_camera(), conversion, width, height, probe);
}

inline Conversion with_budget(double value, bool is_mm = false) {
  Conversion out;
  out.lens.depth_budget = DepthBudget{value, is_mm};
  return out;
}

}  // namespace lentray::camera
