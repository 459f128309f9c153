// The rays of a gather, summed up: the light they brought and how far they went. World space; colours linear.
// A plain value.
// Source: reference manual 3.7, "importance", "max_sample"; Ward, Rubinstein and Clear, SIGGRAPH 1988 (the
// harmonic mean of the distances).
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/trace/gather_ray.h"

namespace lentray::core {

class GatherSum {
 public:
  /// `wanted`: rays; `most`: of a ray's brightest channel, where it is positive.
  GatherSum(unsigned wanted, double most) : m_wanted(wanted), m_most(most) {}
  /// `quality`: of the samples that lit what the ray met.
  void add(const GatherRay& ray, const GatheredRay& seen, double quality) {
    ++m_rays;
    add_distance(ray.ray.direction, seen.distance);
    if (seen.importance < ray.least_importance) return;
    const double weight = quality * rays_for(seen.importance);
    const Rgb light = limited(seen.light);
    m_quality += weight;
    m_red += weight * light.r;
    m_green += weight * light.g;
    m_blue += weight * light.b;
  }

  unsigned rays() const { return m_rays; }
  /// The mean of the light, each ray by its quality.
  Rgb light() const {
    const double all = m_quality == 0.0 ? 1.0 : m_quality;
    return {static_cast<float>(m_red / all), static_cast<float>(m_green / all),
            static_cast<float>(m_blue / all)};
  }
  /// The mean of the qualities, 0..1.
  double quality() const { return m_rays > 0 ? m_quality / m_rays : 0.0; }
  double nearest() const { return m_nearest; }
  const Vec3& to_nearest() const { return m_to_nearest; }  ///< unit; null: nothing was met
  /// Harmonic; infinite if nothing was met.
  double mean_distance() const {
    constexpr double kInfinite = std::numeric_limits<double>::infinity();
    return m_inverse_distances > 0.0 ? m_rays / m_inverse_distances : kInfinite;
  }

 private:
  void add_distance(const Vec3& direction, double distance) {
    m_inverse_distances += 1.0 / distance;
    if (!(distance < m_nearest)) return;
    m_nearest = distance;
    m_to_nearest = direction;
  }
  /// Only the first rays of a gather shade objects of importance below 1. The weight of each makes up for the
  /// rays that do not.
  double rays_for(float importance) const {
    return importance < 1.0f ? m_wanted / (std::floor(importance * (m_wanted - 1.0)) + 1.0) : 1.0;
  }
  Rgb limited(const Rgb& light) const {
    const double brightest = std::max({light.r, light.g, light.b});
    const bool is_too_much = m_most > 0.0 && brightest > m_most;
    return is_too_much ? light * static_cast<float>(m_most / brightest) : light;
  }

  static constexpr double kNowhereNear = 2e10;  ///< the distance if there is nothing
  double m_wanted, m_most;
  unsigned m_rays = 0;
  double m_quality = 0.0, m_red = 0.0, m_green = 0.0, m_blue = 0.0;
  double m_inverse_distances = 0.0, m_nearest = kNowhereNear;
  Vec3 m_to_nearest;
};

}  // namespace lentray::core
