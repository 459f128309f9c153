#include "shadow/direction_policy.h"

#include <algorithm>
#include <cmath>

#include "core/base/bounds.h"

namespace lentray::shadow {
namespace {

/// Where most of the finite objects are: their middle, and how far about it. A few large ones, such
/// as floors, stay outside.
struct Cluster {
  core::Vec3 middle;
  double radius = 1.0;
};

Cluster cluster_of(const core::Scene& scene) {
  constexpr double kSpreads = 2.5;
  double n = 0.0, squares = 0.0, sizes = 0.0;
  core::Vec3 sum;
  for (const auto& object : scene.objects()) {
    const core::Bounds box = object->bounds();
    if (!box.is_finite() || box.is_empty()) continue;
    const core::Vec3 at = box.centre();
    n += 1.0;
    sum += at;
    squares += dot(at, at);
    sizes += 0.5 * length(box.hi - box.lo);
  }
  if (n == 0.0) return {};
  Cluster cluster;
  cluster.middle = sum / n;
  const double spread = squares / n - dot(cluster.middle, cluster.middle);
  cluster.radius = std::max(1e-6, kSpreads * std::sqrt(std::max(0.0, spread)) + sizes / n);
  return cluster;
}

/// Any number into -1..1, so that neighbours stay neighbours.
double folded(double x) { return x - 2.0 * std::floor((x + 1.0) * 0.5); }

}  // namespace

DirectionPolicy::DirectionPolicy(const core::Scene& scene) {
  constexpr double kFarLight = 1.5;  // radii from the middle: beyond, a window holds what there is
  const Cluster cluster = cluster_of(scene);
  for (const core::Light& light : scene.lights()) {
    LightFrame frame;
    core::Vec3 along = light.direction;  // to a parallel light
    double reach = 1.0;
    if (!light.parallel) {
      along = light.position - cluster.middle;
      reach = length(along);
    }
    frame.kind = light.parallel                       ? Kind::kParallel
                 : reach > kFarLight * cluster.radius ? Kind::kWindow
                                                      : Kind::kCube;
    if (frame.kind != Kind::kCube) {
      frame.along = along / length(along);
      const core::Vec3 other =
          std::fabs(frame.along.x) < 0.5 ? core::Vec3{1, 0, 0} : core::Vec3{0, 1, 0};
      const double scale = reach / cluster.radius;
      frame.across = normalized(cross(frame.along, other)) * scale;
      frame.up = cross(frame.along, frame.across);
    }
    m_lights.push_back(frame);
  }
}

DirectionPolicy::Place DirectionPolicy::place_of(const core::ShadowQuery& query) const {
  const LightFrame& frame = m_lights[query.light];
  if (frame.kind == Kind::kParallel) {
    return {0, folded(dot(query.ray.origin, frame.across)),
            folded(dot(query.ray.origin, frame.up))};
  }
  const core::Vec3& d = query.ray.direction;
  if (frame.kind == Kind::kWindow) {
    const double along = dot(d, frame.along);  // the light lies that way from the point
    if (along > 0.1) {
      return {0, folded(dot(d, frame.across) / along), folded(dot(d, frame.up) / along)};
    }
  }
  const double x = std::fabs(d.x), y = std::fabs(d.y), z = std::fabs(d.z);
  if (x >= y && x >= z) return {d.x > 0.0 ? 0u : 1u, d.y / x, d.z / x};
  if (y >= z) return {d.y > 0.0 ? 2u : 3u, d.x / y, d.z / y};
  return {d.z > 0.0 ? 4u : 5u, d.x / z, d.y / z};
}

}  // namespace lentray::shadow
