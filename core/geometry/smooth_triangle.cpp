#include "core/geometry/smooth_triangle.h"

#include "core/geometry/bounds_help.h"

namespace lentray::core {
namespace {

/// Stock drops the triangle unless all normals are strictly on one side of it.
bool normals_disagree(const Vec3& face, const std::array<Vec3, 3>& n) {
  const double a = dot(face, n[0]), b = dot(face, n[1]), c = dot(face, n[2]);
  return !((a > 0.0 && b > 0.0 && c > 0.0) || (a < 0.0 && b < 0.0 && c < 0.0));
}

}  // namespace

SmoothTriangle::SmoothTriangle(const Vec3& a, const Vec3& na, const Vec3& b, const Vec3& nb,
                               const Vec3& c, const Vec3& nc)
    : m_vertices{a, b, c}, m_normals{normalized(na), normalized(nb), normalized(nc)},
      m_degenerate(triangle_is_degenerate(a, b, c) ||
                   normals_disagree(cross(c - a, b - a), m_normals)) {}

Bounds SmoothTriangle::bounds() const {
  Bounds b;
  if (m_degenerate) return b;
  for (const Vec3& p : m_vertices) b.include(p);
  return padded(b);
}

bool SmoothTriangle::nearest(const Ray& ray, double t_min, double t_max, ShapeHit& hit) const {
  TriangleHit found;
  if (m_degenerate) return false;
  if (!intersect_triangle(ShearedRay(ray), m_vertices[0], m_vertices[1], m_vertices[2], found))
    return false;
  if (!(found.t > t_min && found.t < t_max)) return false;
  hit = {found.t, 0, found.wb, found.wc};
  return true;
}

void SmoothTriangle::all(const Ray& ray, double t_min, double t_max, ShapeHits& hits) const {
  ShapeHit hit;
  if (SmoothTriangle::nearest(ray, t_min, t_max, hit)) hits.push_back(hit);
}

Vec3 SmoothTriangle::normal(const Vec3&, const ShapeHit& hit) const {
  return m_normals[0] * (1.0 - hit.u - hit.v) + m_normals[1] * hit.u + m_normals[2] * hit.v;
}

std::unique_ptr<Shape> SmoothTriangle::baked(const Transform& t) const {
  auto moved = std::make_unique<SmoothTriangle>(
      t.point(m_vertices[0]), t.normal(m_normals[0]), t.point(m_vertices[1]),
      t.normal(m_normals[1]), t.point(m_vertices[2]), t.normal(m_normals[2]));
  moved->m_degenerate |= m_degenerate;
  return moved;
}

}  // namespace lentray::core
