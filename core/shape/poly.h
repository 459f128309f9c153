// poly, cubic, quartic: surfaces of a polynomial of order 2 to 35 in x, y, z. Space: object.
// Inside is where the polynomial is below 0.0001.
// Source: reference manual 3.7, "Poly, Cubic and Quartic"; compared with stock by tests/image/shapes_test.cpp.
#pragma once

#include <vector>

#include "core/shape/crossings.h"

namespace lentray::core {

inline constexpr int kMaxPolyOrder = 35;

class Poly final : public FewCrossings<Poly, double, kMaxPolyOrder + 1> {
 public:
  /// Coefficients in the order of the manual: powers of x fall slowest, those of z fastest.
  Poly(std::string_view name, int order, const std::vector<double>& coefficients);

  ShapeTraits traits() const override { return {.name = m_name, .finds_all_at_once = true}; }
  Bounds box(const Transform* move) const override { return moved_box(Bounds::everything(), move); }
  bool holds(const Vec3& p, bool inverse) const override { return within(p) != inverse; }
  Vec3 normal(const Vec3& p, const ShapeHit& hit) const override;
  /// Before the shape is asked: crossings beyond the ball are not wanted, and may be left out.
  void keep_within(const Ball& ball) { m_kept = ball; }

 private:
  friend FewCrossings;
  bool within(const Vec3& p) const;
  struct Term {
    double c;
    int i, j, k;  ///< powers of x, y, z
  };
  template <int kOrder>
  void along(const Vec3& p, const Vec3& d, double* c) const;
  void along_any(const Vec3& p, const Vec3& d, double* c) const;
  int crossings(const Ray& ray, double t_min, double t_max, bool first_alone, double* roots) const;
  double value(const Vec3& p) const;

  std::string_view m_name;
  int m_order;
  std::vector<double> m_all;  ///< every coefficient, in the manual's order
  Ball m_kept;                ///< of what crossings are asked for
  std::vector<Term> m_terms;  ///< powers of x falling, then of y, then of z
};

}  // namespace lentray::core
