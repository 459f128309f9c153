#include "core/trace/light_loop.h"

#include <cmath>

#include "core/light/area_light.h"
#include "core/object/leaf.h"
#include "core/scene/tolerances.h"

namespace lentray::core {

bool LightLoop::pass_projector(const Object& projector, ShadowQuery& query) const {
  constexpr double kClear = 1e-3;  ///< nothing so near before the projector counts
  Hit hit;
  if (!projector.nearest(query.ray, kMinHitDistance * m_scene.tolerance_scale(), query.distance,
                         hit, {m_context.lists, RayKind::kShadow})) {
    return false;
  }
  query.distance = hit.t - kClear + m_tolerance;
  return true;
}

Rgb LightLoop::of_area(const Rgb& colour, const LightRay& ray, ShadowQuery& query) {
  const Light& source = m_scene.lights()[query.light];
  query.spot = nullptr;
  auto probe = [&](const Vec3& offset, std::uint32_t sample) {
    const LightRay to_sample = light_ray(source, query.ray.origin, offset);
    query.ray.direction = to_sample.direction;
    query.distance = to_sample.distance;
    query.sample = sample;
    return colour * left(query);
  };
  RandomSequence places(branch_key(query.key, query.light), RandomSequence::Use::kLightArea);
  auto random_number = [&] { return places.next(); };
  const AreaAxes axes = area_axes(source.area, ray.direction);
  return AreaSampler(source.area, axes, m_context.area, probe, random_number).colour();
}

void LightLoop::look_ahead(const LightLists& lists, const Vec3& normal, const Hit& hit,
                           bool from_behind, const Vec3& point, LightsAtPoint& known) const {
  for (const std::span<const std::uint32_t> lights : lists) {
    for (const std::uint32_t i : lights) {
      const LightSource& source = m_sources[i];
      LightBuffer::Spot& spot = known.spots[i];
      spot.known = source.buffer && !source.surely_behind(source.position - point, normal);
      spot.unmet = nullptr;
      if (spot.known) source.buffer->locate(point, spot);
    }
  }
  // In test_cost()'s unit (core/accel/test_cost.h): the test of a simpler object costs no more than
  // this search.
  constexpr double kWorthwhile = 12.0;
  if (hit.object->test_cost() >= kWorthwhile && hit.leaf->convexity() != Convexity::kNone) {
    find_unmet(lists, normal, hit, from_behind, point, known);
  }
}

/// Marks the hit object as not in the way of lights on the front side of a convex surface. Rays whose
/// cosine to the normal is less than `slope` are left out: a point that rounding put inside could
/// still meet it.
void LightLoop::find_unmet(const LightLists& lists, const Vec3& normal, const Hit& hit,
                           bool from_behind, const Vec3& point, LightsAtPoint& known) const {
  constexpr double kLeast = 1e-3, kRounding = 1e-9;
  if (!hit.object->lies_in_parts()) return;
  const bool either_side = hit.leaf->convexity() == Convexity::kFlat && hit.object == hit.leaf;
  if (from_behind && !either_side) return;
  const double off =
      kRounding * (std::fabs(point.x) + std::fabs(point.y) + std::fabs(point.z) + hit.t);
  const double slope = std::max(kLeast, off / m_tolerance);
  for (const std::span<const std::uint32_t> lights : lists) {
    for (const std::uint32_t i : lights) {
      if (!known.spots[i].known || !m_sources[i].straight) continue;
      const Vec3 to = m_sources[i].position - point;
      const double up = dot(normal, to);
      if (up > 0.0 && up * up > slope * slope * length_squared(to))
        known.spots[i].unmet = hit.object;
    }
  }
}

}  // namespace lentray::core
