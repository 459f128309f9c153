// Noise of three numbers at once, and the sum of its octaves.
#include <array>
#include <cstdint>

#include "core/noise/lattice_cell.h"

namespace lentray::core {
namespace {

Vec3 vector_noise_portable(const Vec3& point) {
  const LatticeCell cell(point);
  Vec3 result;
  for_corners(cell, [&](const double* g, double weight, double x, double y, double z) {
    result += Vec3(corner(g, x, y, z), corner(g + 4, x, y, z), corner(g + 8, x, y, z)) * weight;
  });
  return result;
}

/// What the three sums take from the table at one place. A gradient is four of these in a row: the
/// numbers alone, and the factors of x, y and z. Rows overlap, so that all fit beside the hashes into the
/// nearest cache, which twelve numbers a gradient do not.
struct alignas(32) Row {
  double lanes[4];
};
constexpr std::size_t kRows = 256 + 3;

const std::array<Row, kRows> kGradientRows = [] {
  std::array<Row, kRows> rows{};
  for (std::size_t i = 0; i < kRows; ++i) {
    rows[i] = {{kNoiseGradients[i], kNoiseGradients[i + 4], kNoiseGradients[i + 8], 0.0}};
  }
  return rows;
}();

/// vector_noise_portable at a point x, y, z, 1 that is near, to the bit: a lane has one of the three sums.
/// The sums are twice as large and the weights half, which is exact and spares halving the numbers alone.
[[gnu::always_inline]] LENTRAY_AVX2 inline __m256d near_noise(__m256d point) {
  const __m256d one = _mm256_set1_pd(1.0);
  const __m256d below = _mm256_blendv_pd(point, _mm256_sub_pd(point, _mm256_set1_pd(1.0 - kCellEpsilon)), point);
  const __m128i cell = _mm256_cvttpd_epi32(below);
  // Written as vectors and read number by number: a load spreads a number over all lanes for nothing.
  alignas(32) double near[4], far[4], layers[2][4];
  alignas(16) std::uint32_t index[4];
  const __m256d to_near = _mm256_sub_pd(point, _mm256_cvtepi32_pd(cell));
  const __m256d to_far = _mm256_sub_pd(to_near, one);
  _mm256_store_pd(near, _mm256_add_pd(to_near, to_near));
  _mm256_store_pd(far, _mm256_add_pd(to_far, to_far));
  const __m128i place = _mm_add_epi32(cell, _mm_set1_epi32(kLatticeOrigin));
  _mm_store_si128(reinterpret_cast<__m128i*>(index), _mm_and_si128(place, _mm_set1_epi32(kLattice - 1)));
  const __m256d weight_far = s_curve(to_near), weight_near = _mm256_sub_pd(one, weight_far);
  const __m256d even = _mm256_unpacklo_pd(weight_near, weight_far);  // along x, and along z
  const __m256d of_y = _mm256_permute4x64_pd(_mm256_unpackhi_pd(weight_near, weight_far), 0x50);
  const __m256d half = _mm256_set1_pd(0.5);
  const __m256d columns = _mm256_mul_pd(_mm256_mul_pd(_mm256_permute2f128_pd(even, even, 0), of_y), half);
  _mm256_store_pd(layers[0], _mm256_mul_pd(columns, _mm256_permute4x64_pd(even, 0xAA)));
  _mm256_store_pd(layers[1], _mm256_mul_pd(columns, _mm256_permute4x64_pd(even, 0xFF)));

  const std::uint16_t* const hash = kLatticeHash.data();
  const std::uint32_t low = hash[index[0]], high = hash[index[0] + 1];
  const std::uint32_t y = index[1], y_far = y + 1, z = index[2], z_far = z + 1;
  const std::uint32_t hashes[4] = {hash[low ^ y], hash[high ^ y], hash[low ^ y_far], hash[high ^ y_far]};
  const __m256d xs[2] = {_mm256_broadcast_sd(&near[0]), _mm256_broadcast_sd(&far[0])};
  const __m256d ys[2] = {_mm256_broadcast_sd(&near[1]), _mm256_broadcast_sd(&far[1])};
  const __m256d zs[2] = {_mm256_broadcast_sd(&near[2]), _mm256_broadcast_sd(&far[2])};
  __m256d result = _mm256_setzero_pd();
  const auto add = [&](int column, int layer) LENTRAY_AVX2 {
    const std::uint32_t at = hash[hashes[column] ^ (layer ? z_far : z)] & 0xFFu;
    const Row* const g = &kGradientRows[at];
    __m256d sum = _mm256_load_pd(g[0].lanes);
    sum = _mm256_add_pd(sum, _mm256_mul_pd(_mm256_load_pd(g[1].lanes), xs[column & 1]));
    sum = _mm256_add_pd(sum, _mm256_mul_pd(_mm256_load_pd(g[2].lanes), ys[column >> 1]));
    sum = _mm256_add_pd(sum, _mm256_mul_pd(_mm256_load_pd(g[3].lanes), zs[layer]));
    result = _mm256_add_pd(result, _mm256_mul_pd(sum, _mm256_broadcast_sd(&layers[layer][column])));
  };
  add(0, 0);
  add(1, 0);
  add(2, 0);
  add(3, 0);
  add(0, 1);
  add(1, 1);
  add(2, 1);
  add(3, 1);
  return result;
}

LENTRAY_AVX2 inline __m256d load(const Vec3& v, double last) { return _mm256_set_pd(last, v.z, v.y, v.x); }

LENTRAY_AVX2 inline Vec3 stored(__m256d v) {
  alignas(32) double to[4];
  _mm256_store_pd(to, v);
  return {to[0], to[1], to[2]};
}

[[gnu::noinline]] LENTRAY_AVX2 __m256d noise_beyond_cells(__m256d point) {
  return load(vector_noise_portable(stored(point)), 0.0);
}

[[gnu::always_inline]] LENTRAY_AVX2 inline __m256d noise_anywhere(__m256d point) {
  return is_near(point) ? near_noise(point) : noise_beyond_cells(point);
}

[[gnu::noinline]] LENTRAY_AVX2 Vec3 vector_noise_avx2(const Vec3& point) {
  return stored(noise_anywhere(load(point, 1.0)));
}

[[gnu::noinline]] LENTRAY_AVX2 Vec3 vector_turbulence_avx2(const Vec3& point, const Turbulence& turbulence) {
  const __m256d first = load(point, 1.0);
  __m256d result = noise_anywhere(first);
  double scale = turbulence.lambda, weight = turbulence.omega;
  for (int octave = 2; octave <= turbulence.octaves; ++octave) {
    const __m256d one = noise_anywhere(_mm256_mul_pd(first, _mm256_set1_pd(scale)));
    result = _mm256_add_pd(result, _mm256_mul_pd(one, _mm256_set1_pd(weight)));
    scale *= turbulence.lambda;
    weight *= turbulence.omega;
  }
  return stored(result);
}

}  // namespace

Vec3 vector_noise(const Vec3& point) { return has_avx2() ? vector_noise_avx2(point) : vector_noise_portable(point); }

Vec3 vector_turbulence(const Vec3& point, const Turbulence& turbulence) {
  if (has_avx2()) return vector_turbulence_avx2(point, turbulence);
  Vec3 result = vector_noise_portable(point);
  double scale = turbulence.lambda, weight = turbulence.omega;
  for (int octave = 2; octave <= turbulence.octaves; ++octave) {
    result += vector_noise_portable(point * scale) * weight;
    scale *= turbulence.lambda;
    weight *= turbulence.omega;
  }
  return result;
}

}  // namespace lentray::core
