// sphere { centre, radius }. Space: object, or world once baked.
// Source: reference manual 3.7, "Sphere".
#pragma once

#include "core/shape/shape.h"

namespace lentray::core {

/// Where a ray's line meets a sphere: t0 <= t1. `inverse_dd` is 1 / dot(direction, direction).
/// The formula, whose bits a batched test must repeat (no fused operations, this association):
///   oc = centre - origin; tm = dot(oc, d) * inverse_dd; p = oc - d * tm;
///   h = radius2 - dot(p, p); miss if h < 0; s = sqrt(h * inverse_dd); t0 = tm - s, t1 = tm + s
/// with dot(a, b) = (a.x b.x + a.y b.y) + a.z b.z. The distance is taken from the foot of the
/// perpendicular, so that small spheres far away keep their shape.
inline bool sphere_roots(const Ray& ray, double inverse_dd, const Vec3& centre, double radius2,
                         double& t0, double& t1) {
  const Vec3 oc = centre - ray.origin;
  const double tm = dot(oc, ray.direction) * inverse_dd;
  const Vec3 p = oc - ray.direction * tm;
  const double h = radius2 - dot(p, p);
  if (!(h >= 0.0)) return false;
  const double s = std::sqrt(h * inverse_dd);
  t0 = tm - s;
  t1 = tm + s;
  return true;
}

class Sphere final : public Shape {
 public:
  /// A negative radius counts as positive.
  Sphere(const Vec3& centre, double radius);

  const Vec3& centre() const { return m_centre; }
  double radius() const { return m_radius; }
  double radius2() const { return m_radius2; }

  ShapeTraits traits() const override {
    return {.name = "sphere", .convexity = Convexity::kConvex, .has_uv = true};
  }
  Bounds box(const Transform* move) const override { return move ? box_in(*move) : own_box(); }
  Ball ball() const override { return {m_centre, m_radius}; }
  bool nearest(const Ray& ray, double t_min, double t_max, ShapeHit& hit) const override;
  void all(const Ray& ray, double t_min, double t_max, ShapeHits& hits) const override;
  bool any(const Ray& ray, double t_min, double t_max) const override;
  bool holds(const Vec3& p, bool inverse) const override;
  Vec3 normal(const Vec3& p, const ShapeHit& hit) const override;
  Vec2 uv(const Vec3& p, const ShapeHit& hit) const override;
  /// Under similarities.
  std::unique_ptr<Shape> baked(const Transform& t) const override;

 private:
  Bounds own_box() const;
  Bounds box_in(const Transform& t) const;
  Vec3 m_centre;
  double m_radius, m_radius2;
  std::unique_ptr<const Transform> m_turn;  ///< object to here, for uv; null: only moved, scaled
};

}  // namespace lentray::core
