// bicubic_patch: a Bezier patch as pieces of two triangles, shaded by normals between those of
// their corners. The patch is halved along u and v until a piece is flat enough or u_steps and
// v_steps are used up; neighbours that were not halved alike may leave cracks.
// Space: object, or world once baked: flatness and the blending of normals count there.
// Source: reference manual 3.7, "Bicubic Patch"; compared with stock by tests/image/shapes_test.cpp.
#pragma once

#include <array>
#include <memory>

#include "core/shape/mesh.h"
#include "core/shape/shape.h"

namespace lentray::core {

class BicubicPatch final : public Shape {
 public:
  using Corners = std::array<Vec2, 4>;  ///< texture coordinates: of points 0, 3, 15, 12
  static constexpr Corners kUnitSquare{Vec2{0, 0}, Vec2{1, 0}, Vec2{1, 1}, Vec2{0, 1}};

  /// Rows of four points; steps 0 to 16, both together at most 18. A piece is flat enough if its
  /// control points are nearer than `flatness` to a plane through its corners; 0: none is.
  BicubicPatch(const std::array<Vec3, 16>& points, int u_steps, int v_steps, double flatness,
               const Corners& corners = kUnitSquare);

  ShapeTraits traits() const override {
    return {.name = "bicubic_patch", .is_solid = false, .has_uv = true};
  }
  Bounds box(const Transform* move) const override { return m_net->box(move); }
  bool nearest(const Ray& ray, double t_min, double t_max, ShapeHit& hit) const override {
    return m_net->nearest(ray, t_min, t_max, hit);
  }
  void all(const Ray& ray, double t_min, double t_max, ShapeHits& hits) const override {
    m_net->all(ray, t_min, t_max, hits);
  }
  Vec3 normal(const Vec3& p, const ShapeHit& hit) const override { return m_net->normal(p, hit); }
  Vec2 uv(const Vec3& p, const ShapeHit& hit) const override;
  std::unique_ptr<Shape> baked(const Transform& t) const override;

 private:
  class NetMaker;

  /// Place and slopes at (u, v), u along the rows' order, v along a row.
  void evaluate(double u, double v, Vec3& place, Vec3& by_u, Vec3& by_v) const;

  std::array<Vec3, 16> m_points;
  int m_u_steps, m_v_steps;
  double m_flatness;
  Corners m_corners;
  std::unique_ptr<Mesh> m_net;  ///< its texture coordinates are u and v
};

}  // namespace lentray::core
