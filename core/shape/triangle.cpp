#include "core/shape/triangle.h"

namespace lentray::core {

Triangle::Triangle(const Vec3& a, const Vec3& b, const Vec3& c)
    : TriangleShape(a, b, c, triangle_is_degenerate(a, b, c)),
      m_normal(normalized(cross(c - a, b - a))) {}

Vec3 Triangle::normal(const Vec3&, const ShapeHit&) const { return m_normal; }

std::unique_ptr<Shape> Triangle::baked(const Transform& t) const {
  auto moved = std::make_unique<Triangle>(t.point(m_vertices[0]), t.point(m_vertices[1]),
                                          t.point(m_vertices[2]));
  moved->m_degenerate |= m_degenerate;
  return moved;
}

}  // namespace lentray::core
