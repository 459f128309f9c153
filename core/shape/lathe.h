// lathe: curves of line, quadratic and cubic pieces turned about the y axis. Space: object; of the
// pieces u is the distance from the axis, v the height.
// Source: reference manual 3.7, "Lathe"; compared with stock by tests/image/shapes_test.cpp.
#pragma once

#include <vector>

#include "core/shape/outline.h"
#include "core/shape/shape.h"

namespace lentray::core {

class Lathe final : public Shape {
 public:
  /// `hole`: nothing nearer to the axis is inside.
  explicit Lathe(std::vector<CurvePiece> pieces, double hole = 0.0);

  ShapeTraits traits() const override { return {.name = "lathe", .has_uv = true}; }
  Bounds box(const Transform* move) const override { return move ? box_in(*move) : own_box(); }
  bool nearest(const Ray& ray, double t_min, double t_max, ShapeHit& hit) const override;
  void all(const Ray& ray, double t_min, double t_max, ShapeHits& hits) const override;
  /// Between the curve and the axis or the hole, counted by crossings outwards.
  bool holds(const Vec3& p, bool inverse) const override { return within(p) != inverse; }
  Vec3 normal(const Vec3& p, const ShapeHit& hit) const override;
  /// Around, and along the pieces, each the same share.
  Vec2 uv(const Vec3& p, const ShapeHit& hit) const override;

  template <class Visit>
  void crossings(const Ray& ray, double t_min, double t_max, Visit&& visit) const;

 private:
  friend struct PlainShapes;  // tests/unit/shape/plain_shapes.h
  bool within(const Vec3& p) const;
  Bounds own_box() const;
  Bounds box_in(const Transform& t) const;
  struct Piece {
    CurvePiece curve;
    double low, high, widest;  ///< heights, greatest distance from the axis
  };

  Bounds m_reach;  ///< a little more than bounds()
  std::vector<Piece> m_pieces;
  double m_hole2;  ///< its radius, squared; 0: none
};

}  // namespace lentray::core
