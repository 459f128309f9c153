#include "core/shape/triangle_shape.h"

#include <cmath>

#include "core/numeric/bounds_help.h"
#include "core/numeric/triangle_test.h"

namespace lentray::core {

bool triangle_is_degenerate(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double twice_area = length(cross(c - a, b - a));
  return !(twice_area > 0.0) || !std::isfinite(twice_area);
}

Bounds TriangleShape::box(const Transform* move) const {
  Bounds b;
  if (m_degenerate) return b;
  for (const Vec3& p : m_vertices) b.include(p);
  return moved_box(padded(b), move);
}

bool TriangleShape::nearest(const Ray& ray, double t_min, double t_max, ShapeHit& hit) const {
  TriangleHit found;
  if (m_degenerate) return false;
  if (!intersect_triangle(ShearedRay(ray), m_vertices[0], m_vertices[1], m_vertices[2], found))
    return false;
  if (!(found.t > t_min && found.t < t_max)) return false;
  hit = {found.t, 0, found.wb, found.wc};
  return true;
}

}  // namespace lentray::core
