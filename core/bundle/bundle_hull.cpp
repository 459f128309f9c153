#include "core/bundle/bundle_hull.h"

#include <algorithm>
#include <cmath>

namespace lentray::core {
namespace {

/// Intervals of four hulls along an axis, or of one along all axes.
struct Intervals {
  Double4 o0, o1, d0, d1;
};

struct Least {
  LENTRAY_SIMD32 static Double4 of(Double4 a, Double4 b) { return simd::min(a, b); }
};
struct Greatest {
  LENTRAY_SIMD32 static Double4 of(Double4 a, Double4 b) { return simd::max(a, b); }
};

/// Of two times four numbers.
template <class Which>
LENTRAY_SIMD32 Double4 of_halves(const double* from) {
  return Which::of(simd::double4_at(from), simd::double4_at(from + 4));
}

/// The least or the greatest of eight numbers, of four groups of them.
template <class Which>
LENTRAY_SIMD32 Double4 of_groups(const double* from) {
  const Double4 a = of_halves<Which>(from), b = of_halves<Which>(from + 8),
                c = of_halves<Which>(from + 16), d = of_halves<Which>(from + 24);
  const Double4 ab = Which::of(simd::shuffled<0, 4, 2, 6>(a, b), simd::shuffled<1, 5, 3, 7>(a, b));
  const Double4 cd = Which::of(simd::shuffled<0, 4, 2, 6>(c, d), simd::shuffled<1, 5, 3, 7>(c, d));
  return Which::of(simd::shuffled<0, 1, 4, 5>(ab, cd), simd::shuffled<2, 3, 6, 7>(ab, cd));
}

/// Origin times inverse direction: earlier where the plane is entered, later in the lanes where it is left.
LENTRAY_SIMD32 Float4 rounded_product(Double4 origin, Float4 inverse, Long4 leaves, double error) {
  const Double4 zero{}, rounded = simd::widened(inverse), around = simd::abs(rounded) * error,
                        wider = simd::double4(WideLimits::kWider);
  const Float4 moved =
      simd::narrowed(origin * rounded + simd::chosen(leaves, zero - around, around));
  const Float4 more = simd::narrowed(simd::chosen(leaves, zero - wider, wider));
  return simd::fma(simd::abs(moved), more, moved);
}

/// What the box tests take of four hulls; to the lanes from `lane` on.
LENTRAY_SIMD32 void store_hulls(const Intervals& in, double error, HullAxis& out, int lane) {
  const Double4 zero{}, least = simd::double4(WideLimits::kLeastComponent);
  const Long4 forward = in.d0 > zero, backward = in.d1 < zero, open = ~(forward | backward);
  // No component is smaller than the least; intervals with both signs hold both.
  const Double4 d1 = simd::chosen(backward, simd::min(in.d1, -least), simd::max(in.d1, least));
  const Double4 d0 = simd::chosen(forward, simd::max(in.d0, least), simd::min(in.d0, -least));
  const Float4 for_low = simd::narrowed(1.0 / d1), for_high = simd::narrowed(1.0 / d0);
  simd::store(out.for_low + lane, for_low);
  simd::store(out.low_product + lane, rounded_product(in.o1, for_low, backward, error));
  simd::store(out.for_high + lane, for_high);
  simd::store(out.high_product + lane, rounded_product(in.o0, for_high, forward, error));
  const Double4 infinite = simd::double4(Bounds::kInf);
  simd::store(out.open + lane, simd::narrowed(simd::chosen(open, infinite, zero - infinite)));
}

/// Where the hull may enter the cube from -reach to reach, at 0 or later; false if it misses that.
bool enters_cube(const double (&o0)[4], const double (&o1)[4], const double (&d0)[4],
                 const double (&d1)[4], double reach, double& enter) {
  enter = 0.0;
  double leave = Bounds::kInf;
  for (int a = 0; a < 3; ++a) {
    const bool open = !(d0[a] > 0.0 || d1[a] < 0.0);
    constexpr double kLeast = WideLimits::kLeastComponent;
    const double up = d1[a] < 0.0 ? std::min(d1[a], -kLeast) : std::max(d1[a], kLeast);
    const double down = d0[a] > 0.0 ? std::max(d0[a], kLeast) : std::min(d0[a], -kLeast);
    const double x = (-reach - o1[a]) / up, y = (reach - o0[a]) / down;
    enter = std::max(enter, open ? std::max(x, y) : std::min(x, y));
    if (!open) leave = std::min(leave, std::max(x, y));
  }
  return enter <= leave;
}

LENTRAY_SIMD32 Double4 in_axes(const Double4 (&v)[3][2], int groups, bool least) {
  double found[4] = {};
  for (int a = 0; a < 3; ++a) {
    alignas(32) double each[8];
    simd::store(each, v[a][0]);
    simd::store(each + 4, v[a][1]);
    found[a] =
        least ? *std::min_element(each, each + groups) : *std::max_element(each, each + groups);
  }
  return simd::double4_at(found);
}

}  // namespace

LENTRAY_AVX2 BundleHull::BundleHull(const RayBundle& rays, const WideFrame& frame) {
  const int used = rays.groups();
  Double4 o0[3][2], o1[3][2], d0[3][2], d1[3][2];
  const double offset[3] = {frame.offset.x, frame.offset.y, frame.offset.z};
  for (int a = 0; a < 3; ++a) {
    for (int half = 0; half < 2; ++half) {
      // Groups without rays hold what was there before, which nobody looks at.
      const double* o = rays.origin(a) + 32 * half;
      const double* d = rays.direction(a) + 32 * half;
      o0[a][half] = (of_groups<Least>(o) - offset[a]) * frame.scale;
      o1[a][half] = (of_groups<Greatest>(o) - offset[a]) * frame.scale;
      d0[a][half] = of_groups<Least>(d) * frame.scale;
      d1[a][half] = of_groups<Greatest>(d) * frame.scale;
    }
  }
  Intervals whole{in_axes(o0, used, true), in_axes(o1, used, false), in_axes(d0, used, true),
                  in_axes(d1, used, false)};
  const Double4 steep = simd::max(simd::abs(whole.d0), simd::abs(whole.d1));
  rate = std::max({steep[0], steep[1], steep[2]});
  const Double4 away = simd::max(simd::abs(whole.o0), simd::abs(whole.o1));
  const double far = std::max({away[0], away[1], away[2]});
  constexpr double kTooFar = 0x1p30;
  fails = !(rate > 0x1p-900 && rate < 0x1p900 && far < kTooFar);
  if (fails) return;
  const double slower = 1.0 / rate;
  whole.d0 *= slower;
  whole.d1 *= slower;
  double error = frame.pad, moved = 0.0;
  if (far > kNear) {
    fails = frame.has_far;
    if (fails) return;
    error += far * 0x1p-48;
    alignas(32) double a[4], b[4], c[4], d[4];
    simd::store(a, whole.o0);
    simd::store(b, whole.o1);
    simd::store(c, whole.d0);
    simd::store(d, whole.d1);
    misses = !enters_cube(a, b, c, d, 1.125 + 2.0 * error, moved);
    if (misses) return;
    start = moved / rate;
    slack = 4.0 * error;
  }
  whole.o0 += whole.d0 * moved;
  whole.o1 += whole.d1 * moved;
  HullAxis axes;
  store_hulls(whole, error, axes, 0);
  for (int a = 0; a < 3; ++a) {
    simd::store(all[a].for_low, simd::float8(axes.for_low[a]));
    simd::store(all[a].low_product, simd::float8(axes.low_product[a]));
    simd::store(all[a].for_high, simd::float8(axes.for_high[a]));
    simd::store(all[a].high_product, simd::float8(axes.high_product[a]));
    simd::store(all[a].open, simd::float8(axes.open[a]));
    for (int half = 0; half < 2 && 4 * half < used; ++half) {
      Intervals in{o0[a][half], o1[a][half], d0[a][half] * slower, d1[a][half] * slower};
      in.o0 += in.d0 * moved;
      in.o1 += in.d1 * moved;
      store_hulls(in, error, groups[a], 4 * half);
    }
  }
}

}  // namespace lentray::core
