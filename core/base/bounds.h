// Axis-aligned boxes in double, outwards-safe: what is inside stays inside.
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "core/base/transform.h"
#include "core/base/vec3.h"

namespace lentray::core {

struct Bounds {
  static constexpr double kInf = std::numeric_limits<double>::infinity();
  Vec3 lo{kInf, kInf, kInf};
  Vec3 hi{-kInf, -kInf, -kInf};

  static Bounds everything() { return {{-kInf, -kInf, -kInf}, {kInf, kInf, kInf}}; }
  bool is_empty() const { return !(lo.x <= hi.x && lo.y <= hi.y && lo.z <= hi.z); }
  bool is_finite() const { return core::is_finite(lo) && core::is_finite(hi); }
  void include(const Vec3& p) {
    lo = {std::min(lo.x, p.x), std::min(lo.y, p.y), std::min(lo.z, p.z)};
    hi = {std::max(hi.x, p.x), std::max(hi.y, p.y), std::max(hi.z, p.z)};
  }
  void include(const Bounds& b) {
    if (b.is_empty()) return;
    include(b.lo);
    include(b.hi);
  }
  void intersect(const Bounds& b) {
    lo = {std::max(lo.x, b.lo.x), std::max(lo.y, b.lo.y), std::max(lo.z, b.lo.z)};
    hi = {std::min(hi.x, b.hi.x), std::min(hi.y, b.hi.y), std::min(hi.z, b.hi.z)};
  }
  Vec3 centre() const { return (lo + hi) * 0.5; }
  double surface() const {
    if (is_empty()) return 0.0;
    const Vec3 d = hi - lo;
    return 2.0 * (d.x * d.y + d.y * d.z + d.z * d.x);
  }
  bool contains(const Vec3& p) const {
    return p.x >= lo.x && p.x <= hi.x && p.y >= lo.y && p.y <= hi.y && p.z >= lo.z && p.z <= hi.z;
  }
};

/// The corners of a finite box; none of another.
inline void add_corners(const Bounds& b, std::vector<Vec3>& points) {
  if (b.is_empty() || !b.is_finite()) return;
  for (int i = 0; i < 8; ++i) {
    points.push_back({i & 1 ? b.hi.x : b.lo.x, i & 2 ? b.hi.y : b.lo.y, i & 4 ? b.hi.z : b.lo.z});
  }
}

/// The box of a transformed box; an infinite or empty one stays so.
inline Bounds transformed(const Bounds& b, const Transform& t) {
  if (b.is_empty()) return b;
  if (!b.is_finite()) return Bounds::everything();
  Bounds r;
  for (int i = 0; i < 8; ++i) {
    r.include(t.point({i & 1 ? b.hi.x : b.lo.x, i & 2 ? b.hi.y : b.lo.y, i & 4 ? b.hi.z : b.lo.z}));
  }
  return r;
}

}  // namespace lentray::core
