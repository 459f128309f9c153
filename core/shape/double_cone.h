// cone { base, radius, cap, radius } with radii of different signs: two cones that meet in their tip.
// Space: object. Source: pictures of stock (tests/image/double_cones_test.cpp).
#pragma once

#include "core/shape/cone.h"
#include "core/shape/shape.h"

namespace lentray::core {

class DoubleCone final : public Shape {
 public:
  /// Ends must differ; one radius is below zero, the other above.
  DoubleCone(const Vec3& base, double base_radius, const Vec3& cap, double cap_radius,
             bool open = false);

  ShapeTraits traits() const override { return {.name = "cone", .is_seen_afar = true}; }
  Bounds box(const Transform* move) const override;
  /// Cone::hull() of both.
  void hull(std::vector<Vec3>& points) const;
  bool nearest(const Ray& ray, double t_min, double t_max, ShapeHit& hit) const override;
  void all(const Ray& ray, double t_min, double t_max, ShapeHits& hits) const override;
  bool holds(const Vec3& p, bool inverse) const override {
    return (m_lower.inside(p) || m_upper.inside(p)) != inverse;
  }
  /// ShapeHit::element: as of Cone, and kUpper more for the upper half.
  Vec3 normal(const Vec3& p, const ShapeHit& hit) const override;

 private:
  static constexpr std::uint32_t kUpper = 4;
  DoubleCone(const Vec3& base, double base_radius, const Vec3& tip, const Vec3& cap,
             double cap_radius, bool open);

  Cone m_lower, m_upper;  ///< the tip is the cap of the one and the base of the other
};

}  // namespace lentray::core
