// Lattice noise in a plane of coordinate 0, which landscapes are made of: half the corners of a cell weigh nothing.
#include <array>
#include <cstdint>

#include "core/base/thread_table.h"
#include "core/noise/lattice.h"
#include "core/noise/noise_table.h"

namespace lentray::core {
namespace {

/// Which coordinates u and v are.
constexpr int first_of(int axis) { return axis == 0 ? 1 : 0; }
constexpr int second_of(int axis) { return axis == 2 ? 1 : 2; }

template <class Number>
std::array<Number, 3> in_space(int axis, Number u, Number v) {
  std::array<Number, 3> p{};
  p[static_cast<std::size_t>(first_of(axis))] = u;
  p[static_cast<std::size_t>(second_of(axis))] = v;
  return p;
}

/// The four corners of a cell: the halves of the first numbers of their gradients, then those along u and v.
struct PlaneCell {
  alignas(32) double corners[3][4];
  alignas(16) std::array<int, 4> key{};  ///< u, axis + 1, v, axis + 1; of none 0

  LENTRAY_AVX2 void fill(Int4 of, int axis);
};

[[gnu::noinline]] LENTRAY_AVX2 void PlaneCell::fill(Int4 of, int axis) {
  simd::store(key.data(), of);
  for (int corner = 0; corner < 4; ++corner) {
    const auto at = in_space(axis, key[0] + (corner & 1), key[2] + (corner >> 1));
    const auto place = [&](std::size_t i) { return at[i] + kLatticeOrigin; };
    const double* const gradient =
        &kNoiseGradients[lattice_hash(place(0), place(1), place(2)) & 0xFFu];
    corners[0][corner] = gradient[0] * 0.5;
    corners[1][corner] = gradient[1 + first_of(axis)];
    corners[2][corner] = gradient[1 + second_of(axis)];
  }
}

constexpr std::size_t kKnownCells = 512;
using KnownCells = std::array<PlaneCell, kKnownCells>;

/// Two points: u, v of the one, u, v of the other.
struct Places {
  Double4 point;
  Int4 cell;

  LENTRAY_AVX2 explicit Places(Double4 p)
      : point(p), cell(simd::truncated(simd::chosen(p, p - (1.0 - kCellEpsilon), p))) {}

  LENTRAY_AVX2 Int4 key(int which, int axis) const {
    const Int4 tag = simd::int4(axis + 1);
    return which == 0 ? simd::shuffled<0, 4, 1, 5>(cell, tag)
                      : simd::shuffled<2, 6, 3, 7>(cell, tag);
  }
  /// Where the cell is kept; neighbours have different ones.
  LENTRAY_AVX2 PlaneCell& known(int which) const {
    const auto both = static_cast<std::uint64_t>(Long2(cell)[which]);
    return table_of_thread<KnownCells>()[(both + (both >> 28)) % kKnownCells];
  }
};

LENTRAY_AVX2 inline bool is(const PlaneCell& cell, Int4 key) {
  return simd::are_same(key, simd::int4_at(cell.key.data()));
}

/// What the corners of both points' cells give.
struct CornerValues {
  Double4 first, second;
};

[[gnu::always_inline]] LENTRAY_AVX2 inline Double4 values(const PlaneCell& cell, Double4 pu,
                                                          Double4 pv, Double4 wu, Double4 wv) {
  const auto& g = cell.corners;
  const Double4 sum = simd::double4_at(g[0]) + simd::double4_at(g[1]) * pu;
  return wu * wv * (sum + simd::double4_at(g[2]) * pv);
}

[[gnu::always_inline]] LENTRAY_AVX2 inline CornerValues corner_values(const Places& at,
                                                                      const PlaneCell& a,
                                                                      const PlaneCell& b) {
  const Double4 near = at.point - simd::widened(at.cell);
  const Double4 far = near - 1.0;
  const Double4 weight_far = s_curve(near), weight_near = 1.0 - weight_far;
  const Double4 u = simd::shuffled<0, 4, 2, 6>(near, far),
                v = simd::shuffled<1, 5, 3, 7>(near, far);
  const Double4 weight_u = simd::shuffled<0, 4, 2, 6>(weight_near, weight_far);
  const Double4 weight_v = simd::shuffled<1, 5, 3, 7>(weight_near, weight_far);
  return {values(a, simd::shuffled<0, 1, 0, 1>(u), simd::shuffled<0, 0, 1, 1>(v),
                 simd::shuffled<0, 1, 0, 1>(weight_u), simd::shuffled<0, 0, 1, 1>(weight_v)),
          values(b, simd::shuffled<2, 3, 2, 3>(u), simd::shuffled<2, 2, 3, 3>(v),
                 simd::shuffled<2, 3, 2, 3>(weight_u), simd::shuffled<2, 2, 3, 3>(weight_v))};
}

LENTRAY_AVX2 NoisePair plane_pair_avx2(int axis, NoisePair u, NoisePair v, int generator);

[[gnu::noinline]] LENTRAY_AVX2 NoisePair in_new_cells(int axis, NoisePair u, NoisePair v,
                                                      int generator) {
  const Places places(simd::joined(simd::shuffled<0, 2>(u, v), simd::shuffled<1, 3>(u, v)));
  PlaneCell &a = places.known(0), &b = places.known(1);
  const Int4 key_a = places.key(0, axis), key_b = places.key(1, axis);
  // Of two that share a place one only can be kept.
  const bool is_shared = &a == &b && !simd::are_same(key_a, key_b);
  if (is_shared || !is_near(places.point)) {
    const auto p = in_space(axis, u, v);
    return lattice_noise(p[0], p[1], p[2], generator);
  }
  if (!is(a, key_a)) a.fill(key_a, axis);
  if (!is(b, key_b)) b.fill(key_b, axis);
  return plane_pair_avx2(axis, u, v, generator);
}

[[gnu::noinline]] LENTRAY_AVX2 NoisePair plane_pair_avx2(int axis, NoisePair u, NoisePair v,
                                                         int generator) {
  const Places places(simd::joined(simd::shuffled<0, 2>(u, v), simd::shuffled<1, 3>(u, v)));
  const PlaneCell &a = places.known(0), &b = places.known(1);
  const bool are_known = is(a, places.key(0, axis)) && is(b, places.key(1, axis));
  if (!are_known) [[unlikely]]
    return in_new_cells(axis, u, v, generator);
  const CornerValues values = corner_values(places, a, b);
  const Double4 even = simd::shuffled<0, 4, 2, 6>(values.first, values.second);
  const Double4 odd = simd::shuffled<1, 5, 3, 7>(values.first, values.second);
  Double2 sum = simd::first_half(even) + simd::first_half(odd);
  sum += simd::last_half(even);
  return in_range(sum + simd::last_half(odd), generator);
}

}  // namespace

double lattice_noise_in_plane(int axis, double u, double v, int generator) {
  if (has_avx2()) return plane_pair_avx2(axis, NoisePair{u, u}, NoisePair{v, v}, generator)[0];
  const auto p = in_space(axis, u, v);
  return lattice_noise(p[0], p[1], p[2], generator);
}

NoisePair lattice_noise_in_plane(int axis, NoisePair u, NoisePair v, int generator) {
  if (has_avx2()) return plane_pair_avx2(axis, u, v, generator);
  const auto p = in_space(axis, u, v);
  return lattice_noise(p[0], p[1], p[2], generator);
}

}  // namespace lentray::core
