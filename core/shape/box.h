// box { corner, corner }. Space: object. Source: reference manual 3.7, "Box".
#pragma once

#include "core/shape/crossings.h"

namespace lentray::core {

class Box final : public FewCrossings<Box, Crossing, 2> {
 public:
  /// Any two opposite corners.
  Box(const Vec3& corner1, const Vec3& corner2);

  const Vec3& lo() const { return m_lo; }
  const Vec3& hi() const { return m_hi; }

  ShapeTraits traits() const override {
    return {.name = "box", .convexity = Convexity::kConvex, .has_uv = true, .is_seen_afar = true};
  }
  Bounds box(const Transform* move) const override { return moved_box({m_lo, m_hi}, move); }
  bool holds(const Vec3& p, bool inverse) const override {
    return Bounds{m_lo, m_hi}.contains(p) != inverse;
  }
  /// By side: ShapeHit::element is 2 * axis + (1 if the upper side).
  Vec3 normal(const Vec3& p, const ShapeHit& hit) const override;
  Vec2 uv(const Vec3& p, const ShapeHit& hit) const override;
  /// Under moves and scales along the axes.
  std::unique_ptr<Shape> baked(const Transform& t) const override;
  /// core/shape/crossings.h.
  int crossings(const Ray& ray, double t_min, double t_max, bool first_alone, Crossing* out) const;

 private:
  Vec3 m_lo, m_hi;
};

}  // namespace lentray::core
