// smooth_triangle { a, na, b, nb, c, nc }: a triangle that is shaded by interpolated normals.
// Space: object, or world once baked. Source: reference manual 3.7, "Triangle and Smooth Triangle".
#pragma once

#include <array>

#include "core/geometry/shape.h"
#include "core/geometry/triangle_test.h"

namespace lentray::core {

class SmoothTriangle final : public Shape {
 public:
  /// Normals need not be unit. A degenerate triangle is allowed: nothing meets it.
  SmoothTriangle(const Vec3& a, const Vec3& na, const Vec3& b, const Vec3& nb, const Vec3& c,
                 const Vec3& nc);

  const std::array<Vec3, 3>& vertices() const { return m_vertices; }
  const std::array<Vec3, 3>& normals() const { return m_normals; }
  bool is_degenerate() const { return m_degenerate; }

  std::string_view name() const override { return "smooth_triangle"; }
  Bounds bounds() const override;
  /// ShapeHit::u, v: the weights of b and c.
  bool nearest(const Ray& ray, double t_min, double t_max, ShapeHit& hit) const override;
  void all(const Ray& ray, double t_min, double t_max, ShapeHits& hits) const override;
  bool inside(const Vec3&) const override { return false; }
  bool outside(const Vec3&) const override { return false; }
  bool is_solid() const override { return false; }
  Vec3 normal(const Vec3& p, const ShapeHit& hit) const override;
  std::unique_ptr<Shape> baked(const Transform& t) const override;

 private:
  std::array<Vec3, 3> m_vertices;
  std::array<Vec3, 3> m_normals;  ///< unit
  bool m_degenerate;
};

}  // namespace lentray::core
