#include "core/geometry/triangle.h"

#include "core/geometry/bounds_help.h"

namespace lentray::core {

bool triangle_is_degenerate(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double twice_area = length(cross(c - a, b - a));
  return !(twice_area > 0.0) || !std::isfinite(twice_area);
}

Triangle::Triangle(const Vec3& a, const Vec3& b, const Vec3& c)
    : m_vertices{a, b, c}, m_normal(normalized(cross(c - a, b - a))),
      m_degenerate(triangle_is_degenerate(a, b, c)) {}

Bounds Triangle::bounds() const {
  Bounds b;
  if (m_degenerate) return b;
  for (const Vec3& p : m_vertices) b.include(p);
  return padded(b);
}

bool Triangle::nearest(const Ray& ray, double t_min, double t_max, ShapeHit& hit) const {
  TriangleHit found;
  if (m_degenerate) return false;
  if (!intersect_triangle(ShearedRay(ray), m_vertices[0], m_vertices[1], m_vertices[2], found))
    return false;
  if (!(found.t > t_min && found.t < t_max)) return false;
  hit = {found.t, 0, found.wb, found.wc};
  return true;
}

void Triangle::all(const Ray& ray, double t_min, double t_max, ShapeHits& hits) const {
  ShapeHit hit;
  if (Triangle::nearest(ray, t_min, t_max, hit)) hits.push_back(hit);
}

Vec3 Triangle::normal(const Vec3&, const ShapeHit&) const { return m_normal; }

std::unique_ptr<Shape> Triangle::baked(const Transform& t) const {
  auto moved = std::make_unique<Triangle>(t.point(m_vertices[0]), t.point(m_vertices[1]),
                                          t.point(m_vertices[2]));
  moved->m_degenerate |= m_degenerate;
  moved->m_normal = normalized(t.normal(m_normal));  // a mirror does not turn it round
  return moved;
}

}  // namespace lentray::core
