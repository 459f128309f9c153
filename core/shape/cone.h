// cone { base, radius, cap, radius [open] }, a frustum. Space: object, or world once baked.
// Source: reference manual 3.7, "Cone".
#pragma once

#include "core/shape/crossings.h"
#include "core/shape/shape.h"

namespace lentray::core {

class Cone final : public Shape {
 public:
  /// Ends must differ (is_degenerate otherwise: nothing hits it). Equal radii are allowed.
  Cone(const Vec3& base, double base_radius, const Vec3& cap, double cap_radius, bool open = false);

  bool is_degenerate() const {
    return !(m_length > 0.0) || (m_base_radius == 0.0 && m_slope == 0.0);
  }
  bool is_open() const { return m_open; }

  ShapeTraits traits() const override {
    return {.name = "cone",
            .convexity = m_open ? Convexity::kOpen : Convexity::kConvex,
            .is_seen_afar = true};
  }
  Bounds box(const Transform* move) const override;
  Ball ball() const override;
  /// Appends points with the whole surface in their convex hull, but for rounding.
  void hull(std::vector<Vec3>& points) const;
  bool nearest(const Ray& ray, double t_min, double t_max, ShapeHit& hit) const override;
  void all(const Ray& ray, double t_min, double t_max, ShapeHits& hits) const override;
  /// An open one is as solid as a closed one.
  bool holds(const Vec3& p, bool inverse) const override { return within(p) != inverse; }
  /// ShapeHit::element: 0 side, 1 base, 2 cap.
  Vec3 normal(const Vec3& p, const ShapeHit& hit) const override;
  /// Under similarities.
  std::unique_ptr<Shape> baked(const Transform& t) const override;

 private:
  bool within(const Vec3& p) const;
  int crossings(const Ray& ray, double t_min, Crossing out[2]) const;

  Vec3 m_base, m_axis;  ///< axis unit, from base to cap
  double m_length;
  double m_base_radius, m_cap_radius, m_slope;  ///< radius at height z: base_radius + slope * z
  bool m_open;
};

}  // namespace lentray::core
