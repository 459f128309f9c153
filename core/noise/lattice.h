// What noise.cpp and lattice.cpp share: the generator of their tables, the range, and the lattice noise
// of generators 1 and 2.
#pragma once

#include <immintrin.h>

#include <algorithm>
#include <cstdint>

#include "core/base/processor.h"
#include "core/noise/noise.h"

namespace lentray::core {

/// The generator that fills the tables: 32-bit linear congruence, 15 bits used.
class TableRandom {
 public:
  explicit TableRandom(std::uint32_t seed) : m_state(seed) {}
  int next() {
    m_state = m_state * 1812433253u + 12345u;
    return static_cast<int>((m_state >> 16) & 0x7FFF);
  }

 private:
  std::uint32_t m_state;
};

inline double s_curve(double t) { return t * t * (3.0 - 2.0 * t); }

/// From what the noises give to 0..1.
inline double in_range(double value, int generator) {
  double sum = value + 0.5;
  if (generator == 3) sum = 0.5 * (1.59 * value + 0.985);
  if (generator == 2) sum = (value + 1.05242) * 0.48985582;
  return std::clamp(sum, 0.0, 1.0);
}

LENTRAY_AVX2 inline __m128d in_range(__m128d value, int generator) {
  const auto each = [](double a) LENTRAY_AVX2 { return _mm_set1_pd(a); };
  __m128d sum = _mm_add_pd(value, each(0.5));
  if (generator == 3) sum = _mm_mul_pd(each(0.5), _mm_add_pd(_mm_mul_pd(each(1.59), value), each(0.985)));
  if (generator == 2) sum = _mm_mul_pd(_mm_add_pd(value, each(1.05242)), each(0.48985582));
  return _mm_min_pd(each(1.0), _mm_max_pd(_mm_setzero_pd(), sum));
}

/// The cell of a negative number: less 1 - kCellEpsilon, without its fraction.
inline constexpr double kCellEpsilon = 1e-10;
/// Added to what is hashed.
inline constexpr int kLatticeOrigin = 10000;

/// Beyond, cells are not counted in 32 bits.
inline constexpr double kFarCell = 1e9;

LENTRAY_AVX2 inline bool is_near(__m256d p) {
  const __m256d size = _mm256_andnot_pd(_mm256_set1_pd(-0.0), p);
  return _mm256_movemask_pd(_mm256_cmp_pd(size, _mm256_set1_pd(kFarCell), _CMP_LT_OQ)) == 15;
}

LENTRAY_AVX2 inline __m256d s_curve(__m256d t) {
  const __m256d slope = _mm256_sub_pd(_mm256_set1_pd(3.0), _mm256_mul_pd(_mm256_set1_pd(2.0), t));
  return _mm256_mul_pd(_mm256_mul_pd(t, t), slope);
}

/// Where a cell of x, y, z may be kept, before it is taken modulo the number of places; neighbours have different ones.
LENTRAY_AVX2 inline std::size_t lattice_slot(__m128i cell) {
  const __m128i low_halves = _mm_set_epi8(-1, -1, -1, -1, -1, -1, -1, -1, -1, -1, 9, 8, 5, 4, 1, 0);
  const __m128i sums = _mm_madd_epi16(_mm_shuffle_epi8(cell, low_halves), _mm_set_epi16(0, 0, 0, 0, 0, 64, 8, 1));
  const auto both = static_cast<std::uint64_t>(_mm_cvtsi128_si64(sums));
  return (both + (both >> 32));
}

/// Noise of generator 1 or 2 at a point, 0..1.
double lattice_noise(double x, double y, double z, int generator);
/// The same at two points.
NoisePair lattice_noise(NoisePair x, NoisePair y, NoisePair z, int generator);
/// To the bit the same where the coordinate number `axis` is 0; u and v are the two others.
double lattice_noise_in_plane(int axis, double u, double v, int generator);
NoisePair lattice_noise_in_plane(int axis, NoisePair u, NoisePair v, int generator);

}  // namespace lentray::core
