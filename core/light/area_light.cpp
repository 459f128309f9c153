#include "core/light/area_light.h"

#include <algorithm>

namespace lentray::core {
namespace {

constexpr double kNearlyAlongZ = 0.01;
constexpr double kOffCentre = 0.001;  ///< keeps the middle sample of a circle from 0 / 0

double grid_place(double step, int size) {
  return size > 1 ? step / static_cast<double>(size - 1) - 0.5 : 0.0;
}

}  // namespace

AreaAxes area_axes(const AreaLight& area, const Vec3& towards_light) {
  if (!area.orient) return {area.axis1, area.axis2};
  const bool along_z = std::fabs(std::fabs(towards_light.z) - 1.0) < kNearlyAlongZ;
  const Vec3 helper = along_z ? Vec3{0.0, 1.0, 0.0} : Vec3{0.0, 0.0, 1.0};
  const double side = length(area.axis1);
  const Vec3 first = normalized(cross(towards_light, helper));
  const Vec3 second = normalized(cross(towards_light, first));
  return {first * side, second * side};
}

Vec3 area_offset(const AreaLight& area, const AreaAxes& axes, double u, double v) {
  double x = grid_place(u, area.size1), y = grid_place(v, area.size2);
  if (area.circular && area.size1 > 1 && area.size2 > 1) {
    x += kOffCentre;
    y += kOffCentre;
    // Squares of the grid become rings: the larger coordinate is the radius.
    const double radius = std::max(std::fabs(x), std::fabs(y));
    const double shrink = radius / std::sqrt(x * x + y * y);
    x *= shrink;
    y *= shrink;
  }
  return axes.first * x + axes.second * y;
}

}  // namespace lentray::core
