#include "core/trace/light_loop.h"

#include <cmath>

#include "core/light/area_light.h"
#include "core/object/leaf.h"
#include "core/scene/tolerances.h"
#include "core/trace/unmet_object.h"

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

Rgb LightLoop::filters(const LitPoint& lit, std::uint32_t light, const BlockLights& block,
                       std::size_t place) const {
  const LightAnswers& answers = *block.of(light);
  const LightRay ray = ray_at(answers, place);
  ShadowQuery query = query_at(lit);
  query.light = light;
  query.spot = &answers.spot[place];
  query.ray.direction = ray.direction;
  query.distance = ray.distance;
  return m_plain->filters(query);
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
  // Rays of other lights run elsewhere: parallel ones, and those of cylinders.
  if (is_straight(source)) {
    query.only = m_shaft.only_object(query.ray.origin, source.position, source.area, axes);
  }
  const Rgb left = AreaSampler(source.area, axes, m_context.area, probe, random_number).colour();
  query.only = {};
  return left;
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
  const UnmetObject unmet = unmet_object(hit, from_behind, point, m_tolerance);
  if (unmet.object) mark_unmet(lists, normal, unmet, point, known);
}

/// Of lights on the front side.
void LightLoop::mark_unmet(const LightLists& lists, const Vec3& normal, const UnmetObject& unmet,
                           const Vec3& point, LightsAtPoint& known) const {
  const double slope2 = unmet.slope * unmet.slope;
  for (const std::span<const std::uint32_t> lights : lists) {
    for (const std::uint32_t i : lights) {
      if (!known.spots[i].known || !m_sources[i].straight) continue;
      const Vec3 to = m_sources[i].position - point;
      const double up = dot(normal, to);
      if (up > 0.0 && up * up > slope2 * length_squared(to)) known.spots[i].unmet = unmet.object;
    }
  }
}

}  // namespace lentray::core
