// Lattice noise in a plane of coordinate 0, which landscapes are made of: half the corners of a cell weigh nothing.
#include <array>
#include <cmath>
#include <cstdint>

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

  LENTRAY_AVX2 void fill(__m128i of, int axis);
};

[[gnu::noinline]] LENTRAY_AVX2 void PlaneCell::fill(__m128i of, int axis) {
  _mm_store_si128(reinterpret_cast<__m128i*>(key.data()), of);
  for (int corner = 0; corner < 4; ++corner) {
    const auto at = in_space(axis, key[0] + (corner & 1), key[2] + (corner >> 1));
    const auto place = [&](std::size_t i) { return at[i] + kLatticeOrigin; };
    const double* const gradient = &kNoiseGradients[lattice_hash(place(0), place(1), place(2)) & 0xFFu];
    corners[0][corner] = gradient[0] * 0.5;
    corners[1][corner] = gradient[1 + first_of(axis)];
    corners[2][corner] = gradient[1 + second_of(axis)];
  }
}

constexpr std::size_t kKnownCells = 512;
thread_local constinit std::array<PlaneCell, kKnownCells> t_cells{};

/// Two points: u, v of the one, u, v of the other.
struct Places {
  __m256d point;
  __m128i cell;

  LENTRAY_AVX2 explicit Places(__m256d p)
      : point(p), cell(_mm256_cvttpd_epi32(_mm256_blendv_pd(p, _mm256_sub_pd(p, _mm256_set1_pd(1.0 - kCellEpsilon)), p))) {}

  LENTRAY_AVX2 __m128i key(int which, int axis) const {
    const __m128i tag = _mm_set1_epi32(axis + 1);
    return which == 0 ? _mm_unpacklo_epi32(cell, tag) : _mm_unpackhi_epi32(cell, tag);
  }
  /// Where the cell is kept; neighbours have different ones.
  LENTRAY_AVX2 PlaneCell& known(int which) const {
    const auto both = static_cast<std::uint64_t>(which == 0 ? _mm_cvtsi128_si64(cell) : _mm_extract_epi64(cell, 1));
    return t_cells[(both + (both >> 28)) % kKnownCells];
  }
};

LENTRAY_AVX2 inline bool is(const PlaneCell& cell, __m128i key) {
  const __m128i same = _mm_cmpeq_epi32(key, _mm_load_si128(reinterpret_cast<const __m128i*>(cell.key.data())));
  return _mm_movemask_epi8(same) == 0xFFFF;
}

/// What the corners of both points' cells give.
struct CornerValues {
  __m256d first, second;
};

[[gnu::always_inline]] LENTRAY_AVX2 inline __m256d values(const PlaneCell& cell, __m256d pu, __m256d pv, __m256d wu,
                                                          __m256d wv) {
  const auto& g = cell.corners;
  const __m256d sum = _mm256_add_pd(_mm256_load_pd(g[0]), _mm256_mul_pd(_mm256_load_pd(g[1]), pu));
  return _mm256_mul_pd(_mm256_mul_pd(wu, wv), _mm256_add_pd(sum, _mm256_mul_pd(_mm256_load_pd(g[2]), pv)));
}

[[gnu::always_inline]] LENTRAY_AVX2 inline CornerValues corner_values(const Places& at, const PlaneCell& a,
                                                                      const PlaneCell& b) {
  const __m256d near = _mm256_sub_pd(at.point, _mm256_cvtepi32_pd(at.cell));
  const __m256d far = _mm256_sub_pd(near, _mm256_set1_pd(1.0));
  const __m256d weight_far = s_curve(near), weight_near = _mm256_sub_pd(_mm256_set1_pd(1.0), weight_far);
  const __m256d u = _mm256_unpacklo_pd(near, far), v = _mm256_unpackhi_pd(near, far);
  const __m256d weight_u = _mm256_unpacklo_pd(weight_near, weight_far);
  const __m256d weight_v = _mm256_unpackhi_pd(weight_near, weight_far);
  return {values(a, _mm256_permute2f128_pd(u, u, 0x00), _mm256_permute4x64_pd(v, 0x50),
                 _mm256_permute2f128_pd(weight_u, weight_u, 0x00), _mm256_permute4x64_pd(weight_v, 0x50)),
          values(b, _mm256_permute2f128_pd(u, u, 0x11), _mm256_permute4x64_pd(v, 0xFA),
                 _mm256_permute2f128_pd(weight_u, weight_u, 0x11), _mm256_permute4x64_pd(weight_v, 0xFA))};
}

LENTRAY_AVX2 NoisePair plane_pair_avx2(int axis, NoisePair u, NoisePair v, int generator);

[[gnu::noinline]] LENTRAY_AVX2 NoisePair in_new_cells(int axis, NoisePair u, NoisePair v, int generator) {
  const Places places(_mm256_set_m128d(_mm_unpackhi_pd(u, v), _mm_unpacklo_pd(u, v)));
  PlaneCell &a = places.known(0), &b = places.known(1);
  const __m128i key_a = places.key(0, axis), key_b = places.key(1, axis);
  // Of two that share a place one only can be kept.
  const bool is_shared = &a == &b && _mm_movemask_epi8(_mm_cmpeq_epi32(key_a, key_b)) != 0xFFFF;
  if (is_shared || !is_near(places.point)) {
    const auto p = in_space(axis, u, v);
    return lattice_noise(p[0], p[1], p[2], generator);
  }
  if (!is(a, key_a)) a.fill(key_a, axis);
  if (!is(b, key_b)) b.fill(key_b, axis);
  return plane_pair_avx2(axis, u, v, generator);
}

[[gnu::noinline]] LENTRAY_AVX2 NoisePair plane_pair_avx2(int axis, NoisePair u, NoisePair v, int generator) {
  const Places places(_mm256_set_m128d(_mm_unpackhi_pd(u, v), _mm_unpacklo_pd(u, v)));
  const PlaneCell &a = places.known(0), &b = places.known(1);
  const bool are_known = is(a, places.key(0, axis)) && is(b, places.key(1, axis));
  if (!are_known) [[unlikely]] return in_new_cells(axis, u, v, generator);
  const CornerValues values = corner_values(places, a, b);
  const __m256d even = _mm256_unpacklo_pd(values.first, values.second);
  const __m256d odd = _mm256_unpackhi_pd(values.first, values.second);
  __m128d sum = _mm_add_pd(_mm256_castpd256_pd128(even), _mm256_castpd256_pd128(odd));
  sum = _mm_add_pd(sum, _mm256_extractf128_pd(even, 1));
  return in_range(_mm_add_pd(sum, _mm256_extractf128_pd(odd, 1)), generator);
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
