// Boxes of round things, for the shapes' bounds. Any space.
#pragma once

#include "core/base/bounds.h"

namespace lentray::core {

/// Widened by a few units in the last place of its coordinates: covers the rounding of points
/// that are computed on the surface.
inline Bounds padded(Bounds b) {
  if (b.is_empty()) return b;
  constexpr double kRelative = 4e-15;
  for (int i = 0; i < 3; ++i) {
    const double lo = b.lo[i], hi = b.hi[i];
    if (std::isfinite(lo)) b.lo[i] = lo - kRelative * std::fabs(lo);
    if (std::isfinite(hi)) b.hi[i] = hi + kRelative * std::fabs(hi);
  }
  return b;
}

/// Half-sizes of the box of the ellipsoid with conjugate radii a, b, c (ellipse: c null).
inline Vec3 ellipsoid_extent(const Vec3& a, const Vec3& b, const Vec3& c = {}) {
  return {std::sqrt(a.x * a.x + b.x * b.x + c.x * c.x), std::sqrt(a.y * a.y + b.y * b.y + c.y * c.y),
          std::sqrt(a.z * a.z + b.z * b.z + c.z * c.z)};
}

/// Two unit vectors that with the unit vector `n` make an orthogonal frame.
inline void make_frame(const Vec3& n, Vec3& u, Vec3& v) {
  const Vec3 a{std::fabs(n.x), std::fabs(n.y), std::fabs(n.z)};
  const Vec3 least = a.x <= a.y && a.x <= a.z ? Vec3{1, 0, 0} : a.y <= a.z ? Vec3{0, 1, 0} : Vec3{0, 0, 1};
  u = normalized(cross(n, least));
  v = cross(n, u);
}

/// Box of a circle around `centre`, seen through a transform.
inline Bounds circle_bounds(const Vec3& centre, const Vec3& unit_normal, double radius,
                            const Transform& t) {
  Vec3 u, v;
  make_frame(unit_normal, u, v);
  const Vec3 c = t.point(centre);
  const Vec3 e = ellipsoid_extent(t.vector(u * radius), t.vector(v * radius));
  return {c - e, c + e};
}

/// If the transform keeps angles (moves, turns, mirrors, scales alike), its scale; else 0.
inline double similarity_scale(const Transform& t) {
  constexpr double kAlike = 1e-12;
  const Vec3 x = t.vector({1, 0, 0}), y = t.vector({0, 1, 0}), z = t.vector({0, 0, 1});
  const double xx = dot(x, x), yy = dot(y, y), zz = dot(z, z);
  const double slack = kAlike * xx;
  if (std::fabs(xx - yy) > slack || std::fabs(xx - zz) > slack) return 0.0;
  if (std::fabs(dot(x, y)) > slack || std::fabs(dot(y, z)) > slack || std::fabs(dot(z, x)) > slack) return 0.0;
  return t.is_singular() ? 0.0 : std::sqrt(xx);
}

}  // namespace lentray::core
