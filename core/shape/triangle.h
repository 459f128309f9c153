// triangle { a, b, c }: flat, no solid. Space: object, or world once baked.
// Source: reference manual 3.7, "Triangle and Smooth Triangle".
#pragma once

#include "core/shape/triangle_shape.h"

namespace lentray::core {

class Triangle final : public TriangleShape {
 public:
  /// A degenerate one is allowed: nothing hits it.
  Triangle(const Vec3& a, const Vec3& b, const Vec3& c);

  ShapeTraits traits() const override {
    return {.name = "triangle", .convexity = Convexity::kFlat, .is_solid = false};
  }
  Vec3 normal(const Vec3& p, const ShapeHit& hit) const override;
  std::unique_ptr<Shape> baked(const Transform& t) const override;

 private:
  Vec3 m_normal;
};

}  // namespace lentray::core
