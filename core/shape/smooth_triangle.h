// smooth_triangle { a, na, b, nb, c, nc }: a triangle that is shaded by interpolated normals.
// Space: object, or world once baked. Source: reference manual 3.7, "Triangle and Smooth Triangle".
#pragma once

#include <array>

#include "core/shape/triangle_shape.h"

namespace lentray::core {

class SmoothTriangle final : public TriangleShape {
 public:
  /// The longer a normal, the more it weighs: a transform changes their lengths. A degenerate triangle is
  /// allowed: nothing hits it.
  SmoothTriangle(const Vec3& a, const Vec3& na, const Vec3& b, const Vec3& nb, const Vec3& c,
                 const Vec3& nc);

  const std::array<Vec3, 3>& normals() const { return m_normals; }

  ShapeTraits traits() const override { return {.name = "smooth_triangle", .is_solid = false}; }
  Vec3 normal(const Vec3& p, const ShapeHit& hit) const override;
  std::unique_ptr<Shape> baked(const Transform& t) const override;

 private:
  std::array<Vec3, 3> m_normals;
};

}  // namespace lentray::core
