// cone { base, radius, cap, radius [open] }, a frustum. Space: object, or world once baked.
// Source: reference manual 3.7, "Cone".
#pragma once

#include "core/shape/frustum.h"

namespace lentray::core {

class Cone final : public FewCrossings<Cone, Crossing, 2, Frustum> {
 public:
  /// Equal radii are allowed.
  Cone(const Vec3& base, double base_radius, const Vec3& cap, double cap_radius, bool open = false)
      : FewCrossings(base, base_radius, cap, cap_radius, open) {}

  ShapeTraits traits() const override { return traits_as("cone"); }
  /// Under similarities.
  std::unique_ptr<Shape> baked(const Transform& t) const override;
  /// core/shape/crossings.h.
  int crossings(const Ray& ray, double t_min, double t_max, bool first_alone, Crossing* out) const;
};

}  // namespace lentray::core
