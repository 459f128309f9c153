// torus { major, minor [sturm] }, around the y axis. Space: object.
// Source: reference manual 3.7, "Torus".
#pragma once

#include "core/shape/crossings.h"

namespace lentray::core {

class Torus final : public FewCrossings<Torus, double, 4> {
 public:
  /// SDL's `sturm` changes nothing: the root finder always brackets.
  Torus(double major, double minor);

  double major_radius() const { return m_major; }

  ShapeTraits traits() const override { return {.name = "torus", .has_uv = true}; }
  Bounds box(const Transform* move) const override;
  Ball ball() const override { return {{}, m_major + m_minor}; }
  /// Where minor > major (a spindle) all within the outer surface is inside.
  bool holds(const Vec3& p, bool inverse) const override { return within(p) != inverse; }
  Vec3 normal(const Vec3& p, const ShapeHit& hit) const override;
  Vec2 uv(const Vec3& p, const ShapeHit& hit) const override;

 private:
  friend FewCrossings;
  bool within(const Vec3& p) const;
  int crossings(const Ray& ray, double t_min, double t_max, bool first_alone, double* out) const;
  double m_major, m_minor;
};

}  // namespace lentray::core
