// cylinder { base, cap, radius [open] }. Space: object, or world once baked.
// Source: reference manual 3.7, "Cylinder".
#pragma once

#include "core/shape/frustum.h"

namespace lentray::core {

class Cylinder final : public Frustum {
 public:
  Cylinder(const Vec3& base, const Vec3& cap, double radius, bool open = false)
      : Frustum(base, radius, cap, radius, open) {}

  const Vec3& base() const { return m_base; }
  double radius() const { return m_base_radius; }

  ShapeTraits traits() const override { return traits_as("cylinder"); }
  bool nearest(const Ray& ray, double t_min, double t_max, ShapeHit& hit) const override;
  void all(const Ray& ray, double t_min, double t_max, ShapeHits& hits) const override;
  /// Under similarities.
  std::unique_ptr<Shape> baked(const Transform& t) const override;

 private:
  int crossings(const Ray& ray, double t_min, Crossing out[2]) const;
};

}  // namespace lentray::core
