#include "core/shape/torus.h"

#include <numbers>

#include "core/numeric/bounds_help.h"
#include "core/numeric/roots.h"

namespace lentray::core {

Torus::Torus(double major, double minor) : m_major(std::fabs(major)), m_minor(std::fabs(minor)) {}

Bounds Torus::box(const Transform* move) const {
  const Transform t = move ? *move : Transform();
  // A sphere moved along a circle: their boxes add.
  const Vec3 c = t.point({0, 0, 0});
  const Vec3 ring = ellipsoid_extent(t.vector({m_major, 0, 0}), t.vector({0, 0, m_major}));
  const Vec3 tube = ellipsoid_extent(t.vector({m_minor, 0, 0}), t.vector({0, m_minor, 0}),
                                     t.vector({0, 0, m_minor}));
  return padded({c - ring - tube, c + ring + tube});
}

/// The crossings within the range, ascending; the first, and maybe others, if it is asked for alone.
/// From the point of the ray nearest to the centre the quartic has no cubic term and its
/// coefficients have the size of the torus alone.
int Torus::crossings(const Ray& ray, double t_min, double t_max, bool first_alone,
                     double* out) const {
  const double size = m_major + m_minor;
  const double speed = length(ray.direction);
  const double inverse_speed = 1.0 / speed;
  const Vec3 d = ray.direction * inverse_speed;
  const double shift = -dot(ray.origin, d);
  const Vec3 p = ray.origin + d * shift;
  const double pp = dot(p, p);
  constexpr double kWider = 1e-9;  // of the torus: no root at the interval's ends is lost
  const double reach = size * size * (1.0 + kWider) - pp;
  if (!(reach > 0.0)) return 0;
  double hi = std::sqrt(reach), lo = -hi;
  const double top = m_minor * (1.0 + kWider);
  if (d.y != 0.0) {
    const double y0 = (-top - p.y) / d.y, y1 = (top - p.y) / d.y;
    lo = std::max(lo, std::min(y0, y1));
    hi = std::min(hi, std::max(y0, y1));
  } else if (std::fabs(p.y) > top) {
    return 0;
  }
  lo = std::max(lo, t_min * speed - shift);
  // t_max does not cut: the roots' last bits would depend on what else the ray has hit.
  if (!(lo < hi) || t_max * speed - shift <= lo) return 0;

  const double major2 = m_major * m_major, minor2 = m_minor * m_minor;
  const double k = pp - major2 - minor2;
  const double quartic[5] = {1.0, 0.0, 2.0 * (k + 2.0 * major2 * d.y * d.y),
                             8.0 * major2 * p.y * d.y, k * k + 4.0 * major2 * (p.y * p.y - minor2)};
  double root[4];
  const auto keep = [&](int n) {
    int kept = 0;
    for (int i = 0; i < n; ++i) {
      const double t = (root[i] + shift) * inverse_speed;
      if (t > t_min && t < t_max) out[kept++] = t;
    }
    return kept;
  };
  if (first_alone) {
    const int n = solve_between(quartic, 4, lo, hi, root, true);
    if (n == 0) return 0;
    if (const int kept = keep(n)) return kept;
  }
  return keep(solve_between(quartic, 4, lo, hi, root));
}

bool Torus::within(const Vec3& p) const {
  const double across = std::sqrt(p.x * p.x + p.z * p.z) - m_major;
  return p.y * p.y + across * across <= m_minor * m_minor;
}

Vec3 Torus::normal(const Vec3& p, const ShapeHit&) const {
  const double around = std::sqrt(p.x * p.x + p.z * p.z);
  if (!(around > 1e-10)) return p;
  const double s = m_major / around;
  return {p.x - p.x * s, p.y, p.z - p.z * s};
}

Vec2 Torus::uv(const Vec3& p, const ShapeHit&) const {
  constexpr double pi = std::numbers::pi;
  const double across = std::sqrt(p.x * p.x + p.z * p.z) - m_major;
  return {1.0 - (std::atan2(p.z, p.x) + pi) / (2.0 * pi),
          (std::atan2(p.y, across) + pi) / (2.0 * pi)};
}

}  // namespace lentray::core
