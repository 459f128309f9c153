// disc { centre, normal, radius [, hole radius] }. Space: object, or world once baked.
// Source: reference manual 3.7, "Disc": flat, yet in CSG a half-space as a plane is.
#pragma once

#include "core/shape/crossings.h"

namespace lentray::core {

class Disc final : public OneCrossing<Disc> {
 public:
  Disc(const Vec3& centre, const Vec3& normal, double radius, double hole = 0.0);

  ShapeTraits traits() const override {
    return {.name = "disc", .convexity = Convexity::kFlat, .solid_is_unbounded = true};
  }
  /// Of the surface alone.
  Bounds box(const Transform* move) const override;
  bool nearest(const Ray& ray, double t_min, double t_max, ShapeHit& hit) const override;
  bool holds(const Vec3& p, bool inverse) const override;
  Vec3 normal(const Vec3& p, const ShapeHit& hit) const override;
  /// Under similarities.
  std::unique_ptr<Shape> baked(const Transform& t) const override;

 private:
  Vec3 m_centre, m_normal;  ///< unit
  double m_radius, m_hole;
};

}  // namespace lentray::core
