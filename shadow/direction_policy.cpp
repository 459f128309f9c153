#include "shadow/direction_policy.h"

#include <algorithm>

#include "core/base/bounds.h"

namespace lentray::shadow {
namespace {

/// Of what is finite; 1 if nothing is.
double size_of(const core::Scene& scene) {
  core::Bounds box;
  for (const auto& object : scene.objects()) {
    const core::Bounds one = object->bounds();
    if (one.is_finite()) box.include(one);
  }
  return box.is_empty() ? 1.0 : std::max(1e-6, length(box.hi - box.lo));
}

/// Any number into -1..1, so that neighbours stay neighbours.
double folded(double x) { return x - 2.0 * std::floor((x + 1.0) * 0.5); }

}  // namespace

DirectionPolicy::DirectionPolicy(const core::Scene& scene) {
  const bool any_parallel = std::any_of(scene.lights().begin(), scene.lights().end(),
                                        [](const core::Light& light) { return light.parallel; });
  const double size = any_parallel ? size_of(scene) : 1.0;
  for (const core::Light& light : scene.lights()) {
    LightFrame frame;
    frame.parallel = light.parallel;
    if (light.parallel) {
      const core::Vec3& d = light.direction;
      const core::Vec3 other = std::fabs(d.x) < 0.5 ? core::Vec3{1, 0, 0} : core::Vec3{0, 1, 0};
      frame.across = normalized(cross(d, other));
      frame.up = cross(d, frame.across) / size;
      frame.across /= size;
    }
    m_lights.push_back(frame);
  }
}

DirectionPolicy::Place DirectionPolicy::place_of(const core::ShadowQuery& query) const {
  const LightFrame& frame = m_lights[query.light];
  if (frame.parallel) {
    return {0, folded(dot(query.ray.origin, frame.across)), folded(dot(query.ray.origin, frame.up))};
  }
  const core::Vec3& d = query.ray.direction;
  const double x = std::fabs(d.x), y = std::fabs(d.y), z = std::fabs(d.z);
  if (x >= y && x >= z) return {d.x > 0.0 ? 0u : 1u, d.y / x, d.z / x};
  if (y >= z) return {d.y > 0.0 ? 2u : 3u, d.x / y, d.z / y};
  return {d.z > 0.0 ? 4u : 5u, d.x / z, d.y / z};
}

}  // namespace lentray::shadow
