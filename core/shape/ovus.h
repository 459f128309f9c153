// ovus: an egg of two spheres and the inner part of a spindle torus that touches both smoothly.
// Space: object; the lower sphere about the origin, the upper one about its top.
// Source: reference manual 3.7, "Ovus"; compared with stock by tests/image/shapes_test.cpp.
#pragma once

#include "core/shape/shape.h"

namespace lentray::core {

class Ovus final : public Shape {
 public:
  /// Radii 0 or more, top less than twice the bottom (beyond it is a sphere).
  Ovus(double bottom, double top);

  ShapeTraits traits() const override {
    return {.name = "ovus", .convexity = Convexity::kOpen, .has_uv = true};
  }
  Bounds box(const Transform* move) const override { return move ? box_in(*move) : own_box(); }
  bool nearest(const Ray& ray, double t_min, double t_max, ShapeHit& hit) const override;
  void all(const Ray& ray, double t_min, double t_max, ShapeHits& hits) const override;
  bool holds(const Vec3& p, bool inverse) const override { return within(p) != inverse; }
  Vec3 normal(const Vec3& p, const ShapeHit& hit) const override;
  /// As on a sphere about the point half a top radius up.
  Vec2 uv(const Vec3& p, const ShapeHit& hit) const override;

  template <class Visit>
  void crossings(const Ray& ray, double t_min, double t_max, Visit&& visit) const;

 private:
  bool within(const Vec3& p) const;
  Bounds own_box() const;
  Bounds box_in(const Transform& t) const;
  bool may_meet_waist(const Vec3& q, const Vec3& d, double from) const;

  double m_bottom, m_top;
  double m_waist;              ///< radius of the torus' tube
  double m_spindle, m_height;  ///< the tube's centre: distance beyond the axis, height
  double m_low, m_high;        ///< heights where the spheres end
};

}  // namespace lentray::core
