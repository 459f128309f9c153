// superellipsoid { <e, n> }: ((|x|^(2/e) + |y|^(2/e))^(e/n) + |z|^(2/n)) = 1, within the cube of
// half-size 1. Space: object.
// Source: reference manual 3.7, "Superquadric Ellipsoid"; compared with stock by image.shapes.
#pragma once

#include "core/geometry/shape.h"

namespace lentray::core {

class Superellipsoid final : public Shape {
 public:
  Superellipsoid(double e, double n);

  std::string_view name() const override { return "superellipsoid"; }
  Bounds bounds() const override { return {{-1, -1, -1}, {1, 1, 1}}; }
  Bounds bounds_in(const Transform& t) const override;
  bool nearest(const Ray& ray, double t_min, double t_max, ShapeHit& hit) const override;
  void all(const Ray& ray, double t_min, double t_max, ShapeHits& hits) const override;
  bool inside(const Vec3& p) const override;
  Vec3 normal(const Vec3& p, const ShapeHit& hit) const override;

 private:
  /// A norm of p (of degree 1) less 1.
  double value(const Vec3& p) const;
  /// Calls visit(t) for the crossings along the ray in order; stops when it returns false.
  template <class Visit>
  void crossings(const Ray& ray, double t_min, double t_max, Visit&& visit) const;

  struct Sloped;
  Sloped along(const Ray& ray, double t) const;
  bool approach(const Ray& ray, double from, double to, double& t) const;
  template <class Visit>
  void convex_crossings(const Ray& ray, double lo, double hi, Visit&& visit) const;

  double m_round_xy, m_round_z;  ///< 2/e, 2/n
  bool m_convex;
};

}  // namespace lentray::core
