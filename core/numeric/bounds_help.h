// Boxes of round and of unknown things, for the shapes' bounds. Any space.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/bounds.h"
#include "core/numeric/roots.h"

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

/// Wider by a share of its size that no root's error reaches: for tests before the search for roots.
inline Bounds widened(const Bounds& b) {
  constexpr double kShare = 1e-7;
  if (b.is_empty() || !b.is_finite()) return b;
  const Vec3 by(kShare * length(b.hi - b.lo));
  return {b.lo - by, b.hi + by};
}

/// Half-sizes of the box of the ellipsoid with conjugate radii a, b, c (ellipse: c null).
inline Vec3 ellipsoid_extent(const Vec3& a, const Vec3& b, const Vec3& c = {}) {
  return {std::sqrt(a.x * a.x + b.x * b.x + c.x * c.x),
          std::sqrt(a.y * a.y + b.y * b.y + c.y * c.y),
          std::sqrt(a.z * a.z + b.z * b.z + c.z * c.z)};
}

/// Two unit vectors that with the unit vector `n` make an orthogonal frame.
inline void make_frame(const Vec3& n, Vec3& u, Vec3& v) {
  const Vec3 a{std::fabs(n.x), std::fabs(n.y), std::fabs(n.z)};
  const Vec3 least = a.x <= a.y && a.x <= a.z ? Vec3{1, 0, 0}
                     : a.y <= a.z             ? Vec3{0, 1, 0}
                                              : Vec3{0, 0, 1};
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

/// The corners of an octagon about a circle.
inline void add_around_circle(const Vec3& centre, const Vec3& unit_normal, double radius,
                              std::vector<Vec3>& points) {
  constexpr double kOut = 0.41421356237309515;  // tan(pi / 8), a little more
  Vec3 u, v;
  make_frame(unit_normal, u, v);
  for (const double side : {-radius, radius}) {
    for (const double end : {-kOut * radius, kOut * radius}) {
      points.push_back(centre + u * side + v * end);
      points.push_back(centre + u * end + v * side);
    }
  }
}

/// Whether boxes stay boxes: each axis leads to an axis.
inline bool keeps_axes(const Transform& t) {
  const auto one = [](const Vec3& v) { return (v.x != 0.0) + (v.y != 0.0) + (v.z != 0.0) <= 1; };
  return one(t.vector({1, 0, 0})) && one(t.vector({0, 1, 0})) && one(t.vector({0, 0, 1}));
}

/// Box, seen through a transform, of what lies in d.p <= support(d) for every d (of any length).
/// A little wider, for the rounding of points that are found by iteration.
template <class Support>
Bounds support_bounds(const Transform& t, const Support& support) {
  constexpr double kSlack = 1e-9;
  const Vec3 x = t.vector({1, 0, 0}), y = t.vector({0, 1, 0}), z = t.vector({0, 0, 1}),
             o = t.point({});
  Bounds b;
  for (int i = 0; i < 3; ++i) {
    const Vec3 d{x[i], y[i], z[i]};
    const double down = support(-d), up = support(d);
    const double slack = kSlack * (up + down);
    b.lo[i] = o[i] - down - slack;
    b.hi[i] = o[i] + up + slack;
  }
  return padded(b);
}

/// The most that ((a s + b) s + c) s + d becomes for s in 0..1.
inline double most_of_cubic(double a, double b, double c, double d) {
  double most = std::max(d, a + b + c + d), turn[2];
  const int n = solve_quadratic(3.0 * a, 2.0 * b, c, turn);
  for (int i = 0; i < n; ++i) {
    if (turn[i] > 0.0 && turn[i] < 1.0)
      most = std::max(most, ((a * turn[i] + b) * turn[i] + c) * turn[i] + d);
  }
  return most;
}

/// The support of a set of which may_hold(centre, half) says whether a box can have a part in it:
/// the most that d.p can be in the box, to within `fine`, or less closely if more than `budget`
/// cells have to be looked at. Never too little.
template <class MayHold>
double searched_support(const Bounds& box, const Vec3& d, double fine, int budget,
                        const MayHold& may_hold) {
  struct Cell {
    double far;
    Vec3 centre, half;
  };
  const auto reach = [&](const Vec3& half) {
    return std::fabs(d.x) * half.x + std::fabs(d.y) * half.y + std::fabs(d.z) * half.z;
  };
  const auto less_far = [](const Cell& a, const Cell& b) { return a.far < b.far; };
  const Vec3 middle = box.centre(), size = (box.hi - box.lo) * 0.5;
  const double all = dot(d, middle) + reach(size);
  std::vector<Cell> cells{{all, middle, size}};
  while (!cells.empty()) {
    std::pop_heap(cells.begin(), cells.end(), less_far);
    const Cell top = cells.back();
    cells.pop_back();
    if (2.0 * reach(top.half) <= fine || budget <= 0) return top.far;
    budget -= 8;
    const Vec3 half = top.half * 0.5;
    for (int i = 0; i < 8; ++i) {
      const Vec3 centre = top.centre + Vec3{i & 1 ? half.x : -half.x, i & 2 ? half.y : -half.y,
                                            i & 4 ? half.z : -half.z};
      if (!may_hold(centre, half)) continue;
      cells.push_back({dot(d, centre) + reach(half), centre, half});
      std::push_heap(cells.begin(), cells.end(), less_far);
    }
  }
  return all;  // nothing at all: any answer holds
}

/// If the transform keeps angles (moves, turns, mirrors, scales alike), its scale; else 0.
inline double similarity_scale(const Transform& t) {
  constexpr double kAlike = 1e-12;
  const Vec3 x = t.vector({1, 0, 0}), y = t.vector({0, 1, 0}), z = t.vector({0, 0, 1});
  const double xx = dot(x, x), yy = dot(y, y), zz = dot(z, z);
  const double slack = kAlike * xx;
  if (std::fabs(xx - yy) > slack || std::fabs(xx - zz) > slack) return 0.0;
  if (std::fabs(dot(x, y)) > slack || std::fabs(dot(y, z)) > slack || std::fabs(dot(z, x)) > slack)
    return 0.0;
  return t.is_singular() ? 0.0 : std::sqrt(xx);
}

}  // namespace lentray::core
