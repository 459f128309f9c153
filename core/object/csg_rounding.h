// How far roundings go where the parts of a CSG meet, in multiples of a ray's direction. World space.
// Internal to csg*.cpp.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/base/ray.h"

namespace lentray::core {

inline constexpr double kCoincide = 1e-9;  ///< of the distances: roundings of hits stay below
inline constexpr double kOfFar = 1e-9;     ///< of the largest t: its rounding

inline double sum_of_sizes(const Vec3& v) {
  return std::fabs(v.x) + std::fabs(v.y) + std::fabs(v.z);
}

/// The sizes that the rounding of a hit at t goes by.
inline double distances(const Ray& ray, double t) {
  return std::fabs(t) + std::fabs(ray.origin.x) + std::fabs(ray.origin.y) + std::fabs(ray.origin.z);
}

/// Of t, by where the ray begins.
inline double rounding_of_place(const Ray& ray) {
  constexpr double kOfPlace = 1e-11;
  return kOfPlace * sum_of_sizes(ray.origin) / sum_of_sizes(ray.direction);
}

/// Between which t, widened by more than rounding, a ray is in a closed solid.
struct Passage {
  double from, to;

  /// By its crossings beyond t_min, the first and the last of them. `is_whole`: it is in there for one
  /// stretch at most, whose both ends these are; else it may be there from t_min on.
  Passage(const Ray& ray, double t_min, double first, double last, bool is_whole)
      : from(t_min), to(last) {
    const double slack = kOfFar * (std::fabs(first) + std::fabs(to)) + rounding_of_place(ray);
    if (is_whole) from = first - slack;
    to += slack;
  }
  bool has(double t) const { return t >= from && t <= to; }
};

}  // namespace lentray::core
