// quadric { <A,B,C>, <D,E,F>, <G,H,I>, J }:
// A x2 + B y2 + C z2 + D xy + E xz + F yz + G x + H y + I z + J = 0, inside where <= 0.
// Space: object, or world once baked. Source: reference manual 3.7, "Quadric".
#pragma once

#include <array>

#include "core/shape/crossings.h"

namespace lentray::core {

class Quadric final : public FewCrossings<Quadric, double, 2> {
 public:
  /// In the order of SDL, A to J.
  explicit Quadric(const std::array<double, 10>& coefficients);
  Quadric(const Vec3& squares, const Vec3& products, const Vec3& linear, double constant);

  /// The inverse has the sign of the polynomial turned, and the normal once more.
  ShapeTraits traits() const override {
    return {.name = "quadric", .solid_is_unbounded = m_solid_unbounded};
  }
  /// Tight for ellipsoids; for others as far as they are bounded along the axes.
  Bounds box(const Transform* move) const override { return moved_box(m_bounds, move); }
  bool holds(const Vec3& p, bool inverse) const override;
  Vec3 normal(const Vec3& p, const ShapeHit& hit) const override;
  std::unique_ptr<Shape> baked(const Transform& t) const override;

 private:
  friend FewCrossings;
  double value(const Vec3& from_origin) const;
  Vec3 gradient(const Vec3& from_origin) const;
  int crossings(const Ray& ray, double t_min, double t_max, bool first_alone, double* out) const;
  void find_bounds();

  Vec3 m_sq, m_mix, m_lin;  ///< m_mix: xy, xz, yz
  double m_const;
  Vec3 m_origin;  ///< of the equation: moves do not mix into its coefficients
  Bounds m_bounds;
  bool m_solid_unbounded = false;
};

}  // namespace lentray::core
