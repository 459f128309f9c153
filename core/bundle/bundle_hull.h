// What holds the rays of a bundle: an interval for each number of origin and direction, of all rays and of each
// group of eight. A box that any of the rays may meet is met by the hull. In the frame of a bounding hierarchy, with
// everything rounded outwards as core/bvh/wide_bvh.h does it for one ray. Needs AVX2.
//
// With origins in [o0, o1] and directions in [d0, d1], a ray reaches the low plane p of a slab along an axis no
// earlier than X = (p - o1) / d1, if d1 > 0, and leaves its high plane q no later than Y = (q - o0) / d0, if d0 > 0.
// Where both are negative the two change places, so that min(X, Y) is where the slab is entered and max(X, Y) where
// it is left. Where the signs differ, max(X, Y) is where it is entered, and nothing bounds where it is left.
// Both hold for distances that are not negative: the hull starts where no box is before it.
#pragma once

#include "core/bundle/ray_bundle.h"
#include "core/bvh/wide_bvh.h"

namespace lentray::core {

/// Eight hulls along an axis, a lane each. X = low * for_low - low_product, Y likewise.
struct alignas(32) HullAxis {
  float for_low[8], low_product[8], for_high[8], high_product[8];
  float open[8];  ///< infinite where the directions have both signs, else minus that
};

class BundleHull : public WideLimits {
 public:
  /// `misses`: no ray meets any box. `fails`: it does not pay to ask, or the numbers are too large.
  LENTRAY_AVX2 BundleHull(const RayBundle& rays, const WideFrame& frame);
  bool fails = false;
  HullAxis all[3];     ///< of all rays: every lane the same
  HullAxis groups[3];  ///< a lane a group; those without rays are as the first
};

/// Where hulls meet boxes: from `enter` to `leave`, if the one is not greater than the other.
struct HullRange {
  Float8 enter, leave;

  /// Between 0 and `to`.
  LENTRAY_SIMD32 explicit HullRange(Float8 to) : enter(Float8{}), leave(to) {}
  LENTRAY_SIMD32 void cut(const HullAxis& hull, Float8 low, Float8 high) {
    const Float8 x =
        simd::fms(low, simd::float8_at(hull.for_low), simd::float8_at(hull.low_product));
    const Float8 y =
        simd::fms(high, simd::float8_at(hull.for_high), simd::float8_at(hull.high_product));
    const Float8 open = simd::float8_at(hull.open);
    const Float8 later = simd::max(x, y);
    enter = simd::max(enter, simd::max(simd::min(x, y), simd::min(later, open)));
    leave = simd::min(leave, simd::max(later, open));
  }
  LENTRAY_SIMD32 unsigned meets() const { return simd::signs(enter <= leave); }
};

}  // namespace lentray::core
