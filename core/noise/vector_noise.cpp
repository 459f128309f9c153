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
[[gnu::always_inline]] LENTRAY_AVX2 inline Double4 near_noise(Double4 point) {
  const Double4 one = simd::double4(1.0);
  const Double4 below = simd::chosen(point, point - (1.0 - kCellEpsilon), point);
  const Int4 cell = simd::truncated(below);
  // Written as vectors and read number by number: a load spreads a number over all lanes for nothing.
  alignas(32) double near[4], far[4], layers[2][4];
  alignas(16) int index[4];
  const Double4 to_near = point - simd::widened(cell);
  const Double4 to_far = to_near - one;
  simd::store(near, to_near + to_near);
  simd::store(far, to_far + to_far);
  const Int4 place = cell + kLatticeOrigin;
  simd::store(index, place & (kLattice - 1));
  const Double4 weight_far = s_curve(to_near), weight_near = one - weight_far;
  const Double4 even = simd::shuffled<0, 4, 2, 6>(weight_near, weight_far);  // along x, and along z
  const Double4 of_y =
      simd::shuffled<0, 0, 1, 1>(simd::shuffled<1, 5, 3, 7>(weight_near, weight_far));
  const Double4 half = simd::double4(0.5);
  const Double4 columns = simd::shuffled<0, 1, 0, 1>(even) * of_y * half;
  simd::store(layers[0], columns * simd::shuffled<2, 2, 2, 2>(even));
  simd::store(layers[1], columns * simd::shuffled<3, 3, 3, 3>(even));

  const std::uint16_t* const hash = kLatticeHash.data();
  const std::uint32_t low = hash[index[0]], high = hash[index[0] + 1];
  const std::uint32_t y = index[1], y_far = y + 1, z = index[2], z_far = z + 1;
  const std::uint32_t hashes[4] = {hash[low ^ y], hash[high ^ y], hash[low ^ y_far],
                                   hash[high ^ y_far]};
  const Double4 xs[2] = {simd::spread(&near[0]), simd::spread(&far[0])};
  const Double4 ys[2] = {simd::spread(&near[1]), simd::spread(&far[1])};
  const Double4 zs[2] = {simd::spread(&near[2]), simd::spread(&far[2])};
  Double4 result{};
  const auto add = [&](int column, int layer) LENTRAY_AVX2 {
    const std::uint32_t at = hash[hashes[column] ^ (layer ? z_far : z)] & 0xFFu;
    const Row* const g = &kGradientRows[at];
    Double4 sum = simd::double4_at(g[0].lanes);
    sum += simd::double4_at(g[1].lanes) * xs[column & 1];
    sum += simd::double4_at(g[2].lanes) * ys[column >> 1];
    sum += simd::double4_at(g[3].lanes) * zs[layer];
    result += sum * simd::spread(&layers[layer][column]);
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

LENTRAY_AVX2 inline Double4 load(const Vec3& v, double last) {
  return Double4{v.x, v.y, v.z, last};
}

LENTRAY_AVX2 inline Vec3 stored(Double4 v) {
  alignas(32) double to[4];
  simd::store(to, v);
  return {to[0], to[1], to[2]};
}

[[gnu::noinline]] LENTRAY_AVX2 Double4 noise_beyond_cells(Double4 point) {
  return load(vector_noise_portable(stored(point)), 0.0);
}

[[gnu::always_inline]] LENTRAY_AVX2 inline Double4 noise_anywhere(Double4 point) {
  return is_near(point) ? near_noise(point) : noise_beyond_cells(point);
}

[[gnu::noinline]] LENTRAY_AVX2 Vec3 vector_noise_avx2(const Vec3& point) {
  return stored(noise_anywhere(load(point, 1.0)));
}

[[gnu::noinline]] LENTRAY_AVX2 Vec3 vector_turbulence_avx2(const Vec3& point,
                                                           const Turbulence& turbulence) {
  const Double4 first = load(point, 1.0);
  Double4 result = noise_anywhere(first);
  double scale = turbulence.lambda, weight = turbulence.omega;
  for (int octave = 2; octave <= turbulence.octaves; ++octave) {
    const Double4 one = noise_anywhere(first * scale);
    result += one * weight;
    scale *= turbulence.lambda;
    weight *= turbulence.omega;
  }
  return stored(result);
}

}  // namespace

Vec3 vector_noise(const Vec3& point) {
  return has_avx2() ? vector_noise_avx2(point) : vector_noise_portable(point);
}

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
