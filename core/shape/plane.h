// plane { normal, distance }: the points p with p . n/|n| = distance; inside is against the
// normal. Space: object, or world once baked. Source: reference manual 3.7, "Plane".
#pragma once

#include "core/shape/crossings.h"

namespace lentray::core {

/// Where a ray meets the plane, in multiples of its direction; infinite or not a number where they
/// are parallel.
inline double plane_crossing(const Vec3& normal, double distance, const Ray& ray) {
  return (distance - dot(normal, ray.origin)) / dot(normal, ray.direction);
}

class Plane final : public OneCrossing<Plane> {
 public:
  /// The normal need not be unit; a null one makes a plane that nothing meets.
  Plane(const Vec3& normal, double distance);

  const Vec3& unit_normal() const { return m_normal; }
  double distance() const { return m_distance; }

  ShapeTraits traits() const override { return {.name = "plane"}; }
  /// A half-space where the normal is along an axis, else infinite.
  Bounds box(const Transform* move) const override { return moved_box(own_box(), move); }
  bool nearest(const Ray& ray, double t_min, double t_max, ShapeHit& hit) const override;
  /// On the surface: both inside and outside, within 1e-10.
  bool holds(const Vec3& p, bool inverse) const override;
  Vec3 normal(const Vec3& p, const ShapeHit& hit) const override;
  std::unique_ptr<Shape> baked(const Transform& t) const override;

 private:
  Bounds own_box() const;
  Vec3 m_normal;
  double m_distance;
};

}  // namespace lentray::core
