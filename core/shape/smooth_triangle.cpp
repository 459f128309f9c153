#include "core/shape/smooth_triangle.h"

namespace lentray::core {
namespace {

/// Nothing meets the triangle unless all normals are strictly on one side of it.
bool normals_disagree(const Vec3& face, const std::array<Vec3, 3>& n) {
  const double a = dot(face, n[0]), b = dot(face, n[1]), c = dot(face, n[2]);
  return !((a > 0.0 && b > 0.0 && c > 0.0) || (a < 0.0 && b < 0.0 && c < 0.0));
}

}  // namespace

SmoothTriangle::SmoothTriangle(const Vec3& a, const Vec3& na, const Vec3& b, const Vec3& nb,
                               const Vec3& c, const Vec3& nc)
    : TriangleShape(
          a, b, c,
          triangle_is_degenerate(a, b, c) || normals_disagree(cross(c - a, b - a), {na, nb, nc})),
      m_normals{na, nb, nc} {}

Vec3 SmoothTriangle::normal(const Vec3&, const ShapeHit& hit) const {
  return m_normals[0] * (1.0 - hit.u - hit.v) + m_normals[1] * hit.u + m_normals[2] * hit.v;
}

std::unique_ptr<Shape> SmoothTriangle::baked(const Transform& t) const {
  auto moved = std::make_unique<SmoothTriangle>(t.point(m_vertices[0]), t.normal(m_normals[0]),
                                                t.point(m_vertices[1]), t.normal(m_normals[1]),
                                                t.point(m_vertices[2]), t.normal(m_normals[2]));
  moved->m_degenerate |= m_degenerate;
  return moved;
}

}  // namespace lentray::core
