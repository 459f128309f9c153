// What shapes turned about the y axis share. Space: object.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/ray.h"

namespace lentray::core {

/// A ray about the y axis: counted from where it is nearest to it.
struct AboutAxis {
  double t_near = 0.0;  ///< there
  double near2 = 0.0;   ///< square of the distance from the axis there
  double height = 0.0;  ///< there
  double across = 0.0;  ///< speed across the axis
  double climb = 0.0;   ///< speed along it

  explicit AboutAxis(const Ray& ray) : climb(ray.direction.y) {
    const Vec3 &p = ray.origin, &d = ray.direction;
    const double across2 = d.x * d.x + d.z * d.z;
    across = std::sqrt(across2);
    if (across2 > 0.0) t_near = -(p.x * d.x + p.z * d.z) / across2;
    const double x = p.x + t_near * d.x, z = p.z + t_near * d.z;
    near2 = x * x + z * z;
    height = p.y + t_near * d.y;
  }
};

/// Angle about the y axis from +x towards +z, in turns 0..1; 0 on the axis.
inline double turn_about_axis(const Vec3& p) {
  constexpr double kOnAxis = 1e-10;
  const double across2 = p.x * p.x + p.z * p.z;
  if (!(across2 > kOnAxis)) return 0.0;
  if (p.z == 0.0) return p.x > 0.0 ? 0.0 : 0.5;
  const double turn =
      std::acos(std::clamp(p.x / std::sqrt(across2), -1.0, 1.0)) / (2.0 * std::numbers::pi);
  return p.z < 0.0 ? 1.0 - turn : turn;
}

}  // namespace lentray::core
