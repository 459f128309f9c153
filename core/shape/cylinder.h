// cylinder { base, cap, radius [open] }. Space: object, or world once baked.
// Source: reference manual 3.7, "Cylinder".
#pragma once

#include "core/shape/frustum.h"

namespace lentray::core {

class Cylinder final : public FewCrossings<Cylinder, Crossing, 2, Frustum> {
 public:
  Cylinder(const Vec3& base, const Vec3& cap, double radius, bool open = false)
      : FewCrossings(base, radius, cap, radius, open) {}

  const Vec3& base() const { return m_base; }
  double radius() const { return m_base_radius; }

  ShapeTraits traits() const override { return traits_as("cylinder"); }
  /// Under similarities.
  std::unique_ptr<Shape> baked(const Transform& t) const override;
  /// core/shape/crossings.h.
  int crossings(const Ray& ray, double t_min, double t_max, bool first_alone, Crossing* out) const;
};

}  // namespace lentray::core
