// superellipsoid { <e, n> }: ((|x|^(2/e) + |y|^(2/e))^(e/n) + |z|^(2/n)) = 1, within the cube of
// half-size 1. Space: object.
// Source: reference manual 3.7, "Superquadric Ellipsoid"; compared with stock by tests/image/shapes_test.cpp.
#pragma once

#include <array>

#include "core/shape/shape.h"

namespace lentray::core {

class Superellipsoid final : public Shape {
 public:
  Superellipsoid(double e, double n);

  ShapeTraits traits() const override {
    return {.name = "superellipsoid",
            .convexity = m_convex ? Convexity::kConvex : Convexity::kNone};
  }
  Bounds box(const Transform* move) const override {
    return move ? box_in(*move) : Bounds{{-1, -1, -1}, {1, 1, 1}};
  }
  bool nearest(const Ray& ray, double t_min, double t_max, ShapeHit& hit) const override;
  void all(const Ray& ray, double t_min, double t_max, ShapeHits& hits) const override;
  bool any(const Ray& ray, double t_min, double t_max) const override;
  bool holds(const Vec3& p, bool inverse) const override { return within(p) != inverse; }
  Vec3 normal(const Vec3& p, const ShapeHit& hit) const override;

  /// Calls visit(t) for the crossings along the ray in order; stops when it returns false.
  template <bool kAnywhere = false, class Visit>
  void crossings(const Ray& ray, double t_min, double t_max, Visit&& visit) const;

 private:
  bool within(const Vec3& p) const;
  Bounds box_in(const Transform& t) const;
  /// A norm of p (of degree 1) less 1.
  double value(const Vec3& p) const;

  struct Sloped;
  Sloped along(const Ray& ray, double t) const;
  bool approach(const Ray& ray, double from, double to, double& t) const;
  bool clip(const Ray& ray, double& lo, double& hi) const;
  template <bool kAnywhere, class Visit>
  void convex_crossings(const Ray& ray, double t_min, double t_max, Visit&& visit) const;

  double m_round_xy, m_round_z;  ///< 2/e, 2/n
  bool m_convex;
  /// Of a convex one: how far from the middle the planes lie that touch it and are at the same angle
  /// to two axes (xy, yz, zx), and to all three; not divided by the normal's length.
  std::array<double, 3> m_half_of_two{};
  double m_half_of_three = 0.0;
};

}  // namespace lentray::core
