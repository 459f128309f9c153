#include "parser/stock/quadric_box.h"

#include <algorithm>
#include <cmath>

#include "core/base/tiny.h"

namespace lentray::parser {
namespace {

using core::Bounds;

using core::kTiny;

/// The equation as squares of distances to a centre; of an axis that occurs only linearly the centre
/// is where the constant, taken with the wrong sign as stock does, would be reached.
class Centred {
 public:
  explicit Centred(const std::array<double, 10>& c) {
    const double sign = c[0] < 0.0 ? -1.0 : 1.0;
    double constant = sign * c[9];
    for (std::size_t i = 0; i < 3; ++i) {
      square[i] = flattened(sign * c[i]);
      linear[i] = flattened(sign * c[6 + i]);
      if (square[i] == 0.0 && linear[i] != 0.0) {
        centre[i] = sign * c[9] / linear[i] + 0.0;  // no -0
        constant = 0.0;
      }
    }
    level = -constant;
    for (std::size_t i = 0; i < 3; ++i) {
      if (square[i] == 0.0) continue;
      centre[i] = -linear[i] / (2.0 * square[i]);
      level += linear[i] * linear[i] / (4.0 * square[i]);
    }
    level = flattened(level);
  }

  std::array<double, 3> square, linear, centre{};
  double level;  ///< what the squares add up to

  /// The axis whose square has the other sign; 3: there is none.
  std::size_t odd_axis() const {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      if ((square[i] > 0.0) != (square[j] > 0.0) && (square[j] > 0.0) == (square[k] > 0.0))
        return i;
    }
    return 3;
  }
  /// True of two sheets that face each other along that axis.
  bool has_two_sheets(std::size_t odd) const {
    return level * (square[odd] > 0.0 ? -1.0 : 1.0) < 0.0;
  }

 private:
  static double flattened(double x) { return std::fabs(x) < kTiny ? 0.0 : x; }
};

class BoxCut {
 public:
  BoxCut(const std::array<double, 10>& c, const Bounds& limits) : m_surface(c), m_box(limits) {}

  Bounds made() {
    std::size_t zeros = 0, last_zero = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      if (m_surface.square[i] == 0.0) ++zeros, last_zero = i;
    }
    if (zeros == 0) cut_by_squares();
    if (zeros == 1) cut_along(last_zero);
    return m_box;
  }

 private:
  /// Ellipsoids, cones and hyperboloids of one sheet, which are as wide as the farther end of their
  /// axis lets them be.
  void cut_by_squares() {
    const auto& a = m_surface.square;
    const std::size_t odd = m_surface.odd_axis();
    if (odd == 3) {
      for (int i = 0; i < 3 && m_surface.level > 0.0; ++i) cut(i, m_surface.level / a[index(i)]);
      return;
    }
    const int axis = static_cast<int>(odd);
    const double centre = m_surface.centre[odd];
    if (m_surface.has_two_sheets(odd)) return;
    const double far =
        std::max(std::fabs(m_box.lo[axis] - centre), std::fabs(m_box.hi[axis] - centre));
    // Stock counts every waist as that of the hyperboloid whose level is 1.
    const double waist = m_surface.level == 0.0 ? 0.0 : 1.0;
    for (int i = 0; i < 3; ++i) {
      if (i != axis) cut(i, (waist + std::fabs(a[odd]) * far * far) / std::fabs(a[index(i)]));
    }
  }

  /// Cylinders and paraboloids along an axis.
  void cut_along(std::size_t along) {
    const auto& a = m_surface.square;
    const std::size_t j = (along + 1) % 3, k = (along + 2) % 3;
    if ((a[j] > 0.0) != (a[k] > 0.0)) return;
    double wide = m_surface.level;
    if (wide == 0.0 && m_surface.linear[along] != 0.0) {
      const int axis = static_cast<int>(along);
      const double slope = m_surface.linear[along], end = m_surface.centre[along];
      const bool opens_up = (slope < 0.0) == (a[j] > 0.0);
      double& near = opens_up ? m_box.lo[axis] : m_box.hi[axis];
      near = opens_up ? std::max(near, end) : std::min(near, end);
      wide = std::fabs(slope * ((opens_up ? m_box.hi : m_box.lo)[axis] - end));
    } else if (!(wide > 0.0) || a[j] < 0.0) {
      return;
    }
    cut(static_cast<int>(j), wide / std::fabs(a[j]));
    cut(static_cast<int>(k), wide / std::fabs(a[k]));
  }

  void cut(int axis, double squared) {
    const double centre = m_surface.centre[index(axis)], reach = std::sqrt(squared);
    m_box.lo[axis] = std::max(m_box.lo[axis], centre - reach);
    m_box.hi[axis] = std::min(m_box.hi[axis], centre + reach);
  }
  static std::size_t index(int axis) { return static_cast<std::size_t>(axis); }

  Centred m_surface;
  Bounds m_box;
};

}  // namespace

bool has_products(const std::array<double, 10>& c) {
  return std::fabs(c[3]) > kTiny || std::fabs(c[4]) > kTiny || std::fabs(c[5]) > kTiny;
}

bool is_open_all_around(const std::array<double, 10>& c) {
  const Centred surface(c);
  for (const double square : surface.square) {
    if (square == 0.0) return false;
  }
  const std::size_t odd = surface.odd_axis();
  return odd < 3 && !surface.has_two_sheets(odd);
}

std::array<double, 10> moved_quadric(const std::array<double, 10>& c, const core::Transform& t) {
  if (t.is_identity()) return c;
  // The equation is p Q p of points with a fourth coordinate of 1; the inverse brings points back.
  const double q[4][4] = {{c[0], 0.5 * c[3], 0.5 * c[4], 0.5 * c[6]},
                          {0.5 * c[3], c[1], 0.5 * c[5], 0.5 * c[7]},
                          {0.5 * c[4], 0.5 * c[5], c[2], 0.5 * c[8]},
                          {0.5 * c[6], 0.5 * c[7], 0.5 * c[8], c[9]}};
  const core::Matrix& m = t.inverse_rows();
  const auto back = [&](std::size_t row, std::size_t column) {
    return column < 3 ? m[row][column] : (row == 3 ? 1.0 : 0.0);
  };
  double r[4][4];
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      r[i][j] = 0.0;
      for (std::size_t k = 0; k < 4; ++k) {
        for (std::size_t l = 0; l < 4; ++l) r[i][j] += back(i, k) * q[k][l] * back(j, l);
      }
    }
  }
  return {r[0][0],       r[1][1],       r[2][2],       2.0 * r[0][1], 2.0 * r[0][2],
          2.0 * r[1][2], 2.0 * r[0][3], 2.0 * r[1][3], 2.0 * r[2][3], r[3][3]};
}

core::Bounds quadric_box(const std::array<double, 10>& c, const core::Bounds& limits) {
  return BoxCut(c, limits).made();
}

}  // namespace lentray::parser
