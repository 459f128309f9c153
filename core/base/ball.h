// Balls around things, for a first test of rays: far from what they hold most are turned away by
// them at a fraction of the price of any other test. Any space; outwards-safe like Bounds.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/base/bounds.h"
#include "core/base/ray.h"
#include "core/base/transform.h"

namespace lentray::core {

class Ball {
 public:
  Ball() = default;  ///< holds everything
  Ball(const Vec3& centre, double radius) : m_centre(centre) {
    // Wider by what rounding and the roots' errors never reach.
    constexpr double kShare = 1e-6, kOfPlace = 1e-12;
    const double r = radius * (1.0 + kShare) +
                     kOfPlace * (std::fabs(centre.x) + std::fabs(centre.y) + std::fabs(centre.z));
    if (std::isfinite(r)) m_radius2 = r * r;
  }
  /// Around a box; of an infinite or empty one everything.
  static Ball around(const Bounds& b) {
    return b.is_finite() ? Ball(b.centre(), 0.5 * length(b.hi - b.lo)) : Ball();
  }

  bool is_finite() const { return m_radius2 < Bounds::kInf; }
  const Vec3& centre() const { return m_centre; }
  double radius() const { return std::sqrt(m_radius2); }
  /// Certain: no point of the line lies in it.
  bool is_missed_by(const Ray& ray) const {
    constexpr double kSlack = 1e-12;  // far above the rounding of the way's square
    const Vec3 to = m_centre - ray.origin;
    const double along = dot(to, ray.direction);
    return (length_squared(to) * (1.0 - kSlack) - m_radius2) * length_squared(ray.direction) >
           along * along;
  }
  /// Cuts [lo, hi] to where the line may be in it; false if it is nowhere.
  bool cut(const Ray& ray, double& lo, double& hi) const {
    if (!is_finite()) return true;
    constexpr double kSlack = 1e-12;
    const Vec3 to = m_centre - ray.origin;
    const double size = length_squared(ray.direction), along = dot(to, ray.direction);
    const double far = length_squared(to);
    const double chord = along * along - size * (far * (1.0 - kSlack) - m_radius2);
    if (!(chord >= 0.0)) return false;
    const double half = std::sqrt(chord);
    lo = std::max(lo, (along - half) / size);
    hi = std::min(hi, (along + half) / size);
    return lo <= hi;
  }

 private:
  Vec3 m_centre;
  double m_radius2 = Bounds::kInf;
};

inline Ball smaller(const Ball& a, const Ball& b) { return b.radius() < a.radius() ? b : a; }

/// The ball of a ball's image.
inline Ball transformed(const Ball& ball, const Transform& t) {
  if (!ball.is_finite()) return ball;
  const Vec3 x = t.vector({1, 0, 0}), y = t.vector({0, 1, 0}), z = t.vector({0, 0, 1});
  // No length grows more than by the root of the greatest sum of a row of the products.
  const double xy = std::fabs(dot(x, y)), yz = std::fabs(dot(y, z)), zx = std::fabs(dot(z, x));
  const double most = std::max({dot(x, x) + xy + zx, dot(y, y) + xy + yz, dot(z, z) + yz + zx});
  return {t.point(ball.centre()), ball.radius() * std::sqrt(most)};
}

/// A ball around the image of a box.
inline Ball ball_around(const Bounds& box, const Transform& t) {
  if (!box.is_finite()) return {};
  const Vec3 half = (box.hi - box.lo) * 0.5;
  double most = 0.0;  // of the four diagonals
  for (int i = 0; i < 4; ++i) {
    const Vec3 corner{half.x, i & 1 ? -half.y : half.y, i & 2 ? -half.z : half.z};
    most = std::max(most, length_squared(t.vector(corner)));
  }
  return {t.point(box.centre()), std::sqrt(most)};
}

}  // namespace lentray::core
