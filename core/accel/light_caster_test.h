// The exact test of a caster of a light buffer. Internal to the buffers. World space.
#pragma once

#include "core/accel/light_buffer.h"
#include "core/object/leaf.h"
#include "core/shape/box.h"
#include "core/shape/polygon.h"
#include "core/shape/sphere.h"
#include "core/shape/triangle_shape.h"

namespace lentray::core {

/// What a search counts. The other policy is empty and costs nothing. To find a point outside a volume
/// is a test of bounds.
struct Tally {
  Counters& counters;
  void test(const Object* object) const { counters.add_tests(object->name(), 1); }
  void outside() const { ++counters.bounds_tests; }
};
struct NoTally {
  void test(const Object*) const {}
  void outside() const {}
};

template <class Count>
[[gnu::always_inline]] inline LightBuffer::Probe LightBuffer::probe(const Caster& caster,
                                                                    const Ray& ray, double t_min,
                                                                    double t_max, HitLists& lists,
                                                                    Count count) const {
  const auto probe_of = [](bool blocks) { return blocks ? Probe::kBlocks : Probe::kMisses; };
  count.test(caster.object);
  ShapeHit hit;
  switch (caster.kind) {
    case CasterKind::kSphere: {
      const Round& sphere = m_spheres[caster.sphere];
      double t0 = 0.0, t1 = 0.0;
      const double inverse_dd = 1.0 / dot(ray.direction, ray.direction);
      if (!sphere_roots(ray, inverse_dd, sphere.centre, sphere.radius2, t0, t1)) {
        return Probe::kOutside;
      }
      const double t = t0 > t_min ? t0 : t1;
      return probe_of(t > t_min && t < t_max);
    }
    case CasterKind::kPolygon:
      return probe_of(
          static_cast<const Polygon*>(caster.shape)->Polygon::nearest(ray, t_min, t_max, hit));
    case CasterKind::kTriangle:
      return probe_of(
          static_cast<const TriangleShape*>(caster.shape)->nearest(ray, t_min, t_max, hit));
    case CasterKind::kBox:
      return probe_of(static_cast<const Box*>(caster.shape)->Box::nearest(ray, t_min, t_max, hit));
    case CasterKind::kAny: break;
  }
  return probe_of(caster.object->any(ray, t_min, t_max, {lists, RayKind::kShadow}));
}

}  // namespace lentray::core
