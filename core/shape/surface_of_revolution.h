// sor: the square of the distance from the y axis is a cubic of the height, piece by piece.
// Space: object. Source: reference manual 3.7, "Surface of Revolution"; compared with stock by
// tests/image/shapes_test.cpp.
#pragma once

#include <vector>

#include "core/shape/shape.h"

namespace lentray::core {

class SurfaceOfRevolution final : public Shape {
 public:
  /// At least four points (distance from the axis, height), heights ascending; the first and the
  /// last only say how steep the curve is at their neighbours.
  SurfaceOfRevolution(const std::vector<Vec2>& points, bool open);

  ShapeTraits traits() const override { return {.name = "sor", .has_uv = true}; }
  Bounds box(const Transform* move) const override { return move ? box_in(*move) : own_box(); }
  bool nearest(const Ray& ray, double t_min, double t_max, ShapeHit& hit) const override;
  void all(const Ray& ray, double t_min, double t_max, ShapeHits& hits) const override;
  bool any(const Ray& ray, double t_min, double t_max) const override;
  bool holds(const Vec3& p, bool inverse) const override { return within(p) != inverse; }
  Vec3 normal(const Vec3& p, const ShapeHit& hit) const override;
  /// Around, and with the height, each piece the same share; -1..0 and 1..2 on the caps.
  Vec2 uv(const Vec3& p, const ShapeHit& hit) const override;

  template <class Visit>
  void crossings(const Ray& ray, double t_min, const double& t_max, Visit&& visit) const;

 private:
  friend struct PlainShapes;  // tests/unit/shape/plain_shapes.h
  bool within(const Vec3& p) const;
  Bounds own_box() const;
  Bounds box_in(const Transform& t) const;
  /// r^2 = ((c3 s + c2) s + c1) s + c0 with s the height above `low`.
  struct Piece {
    double low, high, c0, c1, c2, c3;
    double widest2;  ///< greatest r^2
    double at(double s) const { return ((c3 * s + c2) * s + c1) * s + c0; }
    double slope(double s) const { return (3.0 * c3 * s + 2.0 * c2) * s + c1; }
  };
  std::uint32_t base() const { return static_cast<std::uint32_t>(m_pieces.size()); }
  std::uint32_t cap() const { return base() + 1; }

  Bounds m_reach;               ///< a little more than bounds()
  std::vector<Piece> m_pieces;  ///< ascending
  bool m_open;
  double m_base2, m_cap2;  ///< r^2 of the flat ends, 0: none
};

}  // namespace lentray::core
