// What triangle and smooth_triangle share: three corners, met from both sides, no solid.
// Space: object, or world once baked.
#pragma once

#include <array>

#include "core/shape/crossings.h"

namespace lentray::core {

class TriangleShape : public OneCrossing<TriangleShape> {
 public:
  const std::array<Vec3, 3>& vertices() const { return m_vertices; }
  bool is_degenerate() const { return m_degenerate; }  ///< nothing hits it

  Bounds box(const Transform* move) const override;
  /// ShapeHit::u, v: the weights of b and c.
  bool nearest(const Ray& ray, double t_min, double t_max, ShapeHit& hit) const final;

 protected:
  TriangleShape(const Vec3& a, const Vec3& b, const Vec3& c, bool degenerate)
      : m_vertices{a, b, c}, m_degenerate(degenerate) {}

  std::array<Vec3, 3> m_vertices;
  bool m_degenerate;
};

/// No area, or corners that are not finite.
bool triangle_is_degenerate(const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace lentray::core
