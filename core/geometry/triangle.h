// triangle { a, b, c }: flat, no solid. Space: object, or world once baked.
// Source: reference manual 3.7, "Triangle and Smooth Triangle".
#pragma once

#include <array>

#include "core/geometry/shape.h"
#include "core/geometry/triangle_test.h"

namespace lentray::core {

class Triangle final : public Shape {
 public:
  /// A degenerate one is allowed: nothing meets it.
  Triangle(const Vec3& a, const Vec3& b, const Vec3& c);

  const std::array<Vec3, 3>& vertices() const { return m_vertices; }
  bool is_degenerate() const { return m_degenerate; }

  std::string_view name() const override { return "triangle"; }
  Bounds bounds() const override;
  bool nearest(const Ray& ray, double t_min, double t_max, ShapeHit& hit) const override;
  void all(const Ray& ray, double t_min, double t_max, ShapeHits& hits) const override;
  bool inside(const Vec3&) const override { return false; }
  bool outside(const Vec3&) const override { return false; }
  bool is_solid() const override { return false; }
  Vec3 normal(const Vec3& p, const ShapeHit& hit) const override;
  std::unique_ptr<Shape> baked(const Transform& t) const override;

 private:
  std::array<Vec3, 3> m_vertices;
  Vec3 m_normal;
  bool m_degenerate;
};

}  // namespace lentray::core
