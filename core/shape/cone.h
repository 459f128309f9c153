// cone { base, radius, cap, radius [open] }, a frustum. Space: object, or world once baked.
// Source: reference manual 3.7, "Cone".
#pragma once

#include "core/shape/frustum.h"

namespace lentray::core {

class Cone final : public Frustum {
 public:
  /// Equal radii are allowed.
  Cone(const Vec3& base, double base_radius, const Vec3& cap, double cap_radius, bool open = false)
      : Frustum(base, base_radius, cap, cap_radius, open) {}

  ShapeTraits traits() const override { return traits_as("cone"); }
  bool nearest(const Ray& ray, double t_min, double t_max, ShapeHit& hit) const override;
  void all(const Ray& ray, double t_min, double t_max, ShapeHits& hits) const override;
  /// Under similarities.
  std::unique_ptr<Shape> baked(const Transform& t) const override;

 private:
  int crossings(const Ray& ray, double t_min, Crossing out[2]) const;
};

}  // namespace lentray::core
