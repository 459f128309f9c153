#include "core/noise/solid_noise.h"

#include <immintrin.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include "core/noise/lattice.h"

namespace lentray::core {
namespace {

constexpr double kSolidOrigin = 10000000.023157213;

/// Perlin's noise of generator 3: gradients on the unit sphere and a permutation.
struct SolidTables {
  static constexpr int kEntries = 2048;
  std::array<int, 2 * (kEntries + 1)> permutation{};
  std::array<Vec3, 2 * (kEntries + 1) + 1> gradients{};  // one more: four numbers are read at once

  SolidTables() {
    TableRandom random(1);
    for (std::size_t i = 0; i < kEntries; ++i) gradients[i] = random_direction(random);
    for (int i = 0; i < kEntries; ++i) permutation[static_cast<std::size_t>(i)] = i;
    // Every other entry is swapped, from the one past the end down.
    for (std::size_t i = kEntries; i > 0; i -= 2) {
      std::swap(permutation[i], permutation[static_cast<std::size_t>(random.next() % kEntries)]);
    }
    for (std::size_t i = 0; i < kEntries + 2; ++i) {
      permutation[kEntries + i] = permutation[i];
      gradients[kEntries + i] = gradients[i];
    }
  }

  static Vec3 random_direction(TableRandom& random) {
    for (;;) {
      Vec3 v;
      for (int axis = 0; axis < 3; ++axis) {
        v[axis] = static_cast<double>(random.next() % (2 * kEntries) - kEntries) / kEntries;
      }
      const double square = length_squared(v);
      if (square <= 1.0 && square >= 1e-5) return v * (1.0 / std::sqrt(square));
    }
  }
};

const SolidTables kSolid;

/// One axis of the solid noise's cell; the offset keeps coordinates positive.
struct SolidAxis {
  int low, high;
  double near, far, weight;
  explicit SolidAxis(double x) {
    const double t = x + kSolidOrigin;
    const double whole = std::floor(t);
    // Where doubles have no odd numbers left any cell will do.
    const std::int64_t cell = std::fabs(whole) < 9e18 ? static_cast<std::int64_t>(whole) : 0;
    low = static_cast<int>(cell & (SolidTables::kEntries - 1));
    high = (low + 1) & (SolidTables::kEntries - 1);
    near = t - whole;
    far = near - 1.0;
    weight = s_curve(near);
  }
};

double solid_noise_portable(const Vec3& p) {
  const SolidAxis x(p.x), y(p.y), z(p.z);
  const auto permuted = [](int i) { return kSolid.permutation[static_cast<std::size_t>(i)]; };
  const int i = permuted(x.low), j = permuted(x.high);
  const int columns[4] = {permuted(i + y.low), permuted(j + y.low), permuted(i + y.high),
                          permuted(j + y.high)};
  const auto value = [&](int column, int layer) {
    const Vec3& g = kSolid.gradients[static_cast<std::size_t>(columns[column] +
                                                              (layer ? z.high : z.low))];
    return (column & 1 ? x.far : x.near) * g.x + (column & 2 ? y.far : y.near) * g.y +
           (layer ? z.far : z.near) * g.z;
  };
  const auto lerp = [](double t, double a, double b) { return a + t * (b - a); };
  const auto plane = [&](int layer) {
    return lerp(y.weight, lerp(x.weight, value(0, layer), value(1, layer)),
                lerp(x.weight, value(2, layer), value(3, layer)));
  };
  return lerp(z.weight, plane(0), plane(1));
}

/// A cell as its corners weigh in: a layer along z has the first numbers of its four gradients, then their
/// second and third.
struct KnownCell {
  alignas(32) double layers[2][3][4];
  alignas(16) std::array<int, 4> index{};  ///< along x, y, z, and 1; of none the last is 0

  void fill(__m128i of);
};

[[gnu::noinline]] void KnownCell::fill(__m128i of) {
  _mm_store_si128(reinterpret_cast<__m128i*>(index.data()), of);
  const auto permuted = [](int i) { return kSolid.permutation[static_cast<std::size_t>(i)]; };
  const auto within = [](int i) { return i & (SolidTables::kEntries - 1); };
  const int i = permuted(within(index[0])), j = permuted(within(index[0] + 1));
  const int y[2] = {within(index[1]), within(index[1] + 1)}, z[2] = {within(index[2]), within(index[2] + 1)};
  const int columns[4] = {permuted(i + y[0]), permuted(j + y[0]), permuted(i + y[1]), permuted(j + y[1])};
  for (int layer = 0; layer < 2; ++layer) {
    for (int column = 0; column < 4; ++column) {
      const Vec3& g = kSolid.gradients[static_cast<std::size_t>(columns[column] + z[layer])];
      for (int axis = 0; axis < 3; ++axis) layers[layer][axis][column] = g[axis];
    }
  }
}

/// Those asked for lately, as for the lattice's.
constexpr std::size_t kKnownCells = 2048;
thread_local constinit std::array<KnownCell, kKnownCells> t_cells{};

/// A point, and the cell it lies in.
struct Place {
  __m256d point;     ///< x, y, z moved, and anything
  __m256d whole;     ///< of it
  __m128i cell;      ///< x, y, z, and 1: unlike that of all cells kept, where it is beyond them
  KnownCell& known;  ///< where it is kept, if it is

  LENTRAY_AVX2 explicit Place(__m256d p) : Place(p, _mm256_floor_pd(p)) {}
  LENTRAY_AVX2 bool is_known() const {
    const __m128i same = _mm_cmpeq_epi32(cell, _mm_load_si128(reinterpret_cast<const __m128i*>(known.index.data())));
    return _mm_movemask_epi8(same) == 0xFFFF;
  }

 private:
  LENTRAY_AVX2 Place(__m256d p, __m256d w) : Place(p, w, cell_of(w)) {}
  LENTRAY_AVX2 Place(__m256d p, __m256d w, __m128i c) : point(p), whole(w), cell(c), known(t_cells[lattice_slot(c) % kKnownCells]) {}
  LENTRAY_AVX2 static __m128i cell_of(__m256d whole) {
    return _mm_blend_epi32(_mm256_cvttpd_epi32(whole), _mm_set1_epi32(1), 8);
  }
};

/// Between the corners of a known cell along x: y low in both layers, y high in both; and the weights.
struct AlongX {
  __m256d value, weight;
};

[[gnu::always_inline]] LENTRAY_AVX2 inline AlongX along_x(const Place& at) {
  const __m256d near = _mm256_sub_pd(at.point, at.whole), far = _mm256_sub_pd(near, _mm256_set1_pd(1.0));
  const __m256d weight = s_curve(near);
  const __m256d xz = _mm256_unpacklo_pd(near, far), only_y = _mm256_unpackhi_pd(near, far);
  const __m256d x = _mm256_permute2f128_pd(xz, xz, 0), y = _mm256_permute4x64_pd(only_y, 0x50);
  const auto layer = [&](const double(&g)[3][4], __m256d z) LENTRAY_AVX2 {
    const __m256d sum = _mm256_add_pd(_mm256_mul_pd(x, _mm256_load_pd(g[0])), _mm256_mul_pd(y, _mm256_load_pd(g[1])));
    return _mm256_add_pd(sum, _mm256_mul_pd(z, _mm256_load_pd(g[2])));
  };
  const __m256d low = layer(at.known.layers[0], _mm256_permute4x64_pd(xz, 0xAA));
  const __m256d high = layer(at.known.layers[1], _mm256_permute4x64_pd(xz, 0xFF));
  const __m256d x_low = _mm256_unpacklo_pd(low, high), x_high = _mm256_unpackhi_pd(low, high);
  const __m256d x_weight = _mm256_permute4x64_pd(weight, 0x00);
  return {_mm256_add_pd(x_low, _mm256_mul_pd(x_weight, _mm256_sub_pd(x_high, x_low))), weight};
}

/// solid_noise_portable of both points, to the bit. Calls nothing where the cells are known.
[[gnu::noinline]] LENTRAY_AVX2 NoisePair solid_pair_avx2(NoisePair x, NoisePair y, NoisePair z);

[[gnu::noinline]] LENTRAY_AVX2 NoisePair in_new_cells(NoisePair x, NoisePair y, NoisePair z, const Place& a, const Place& b) {
  const bool is_shared = &a.known == &b.known && _mm_movemask_epi8(_mm_cmpeq_epi32(a.cell, b.cell)) != 0xFFFF;
  // Of two that share a place one only can be kept.
  if (is_shared || !is_near(a.point) || !is_near(b.point)) {
    const double first = solid_noise_portable({x[0], y[0], z[0]});
    return NoisePair{first, solid_noise_portable({x[1], y[1], z[1]})};
  }
  if (!a.is_known()) a.known.fill(a.cell);
  if (!b.is_known()) b.known.fill(b.cell);
  return solid_pair_avx2(x, y, z);
}

[[gnu::noinline]] LENTRAY_AVX2 NoisePair solid_pair_avx2(NoisePair x, NoisePair y, NoisePair z) {
  const __m128d origin = _mm_set1_pd(kSolidOrigin);
  const __m128d tx = _mm_add_pd(x, origin), ty = _mm_add_pd(y, origin), tz = _mm_add_pd(z, origin);
  const Place a(_mm256_set_m128d(_mm_unpacklo_pd(tz, tz), _mm_unpacklo_pd(tx, ty)));
  const Place b(_mm256_set_m128d(_mm_unpackhi_pd(tz, tz), _mm_unpackhi_pd(tx, ty)));
  if (!a.is_known() || !b.is_known()) [[unlikely]] return in_new_cells(x, y, z, a, b);
  const AlongX of_a = along_x(a), of_b = along_x(b);
  const __m256d y_low = _mm256_permute2f128_pd(of_a.value, of_b.value, 0x20);
  const __m256d y_high = _mm256_permute2f128_pd(of_a.value, of_b.value, 0x31);
  const __m256d weights = _mm256_permute2f128_pd(of_a.weight, of_b.weight, 0x20);
  const __m256d planes = _mm256_add_pd(
      y_low, _mm256_mul_pd(_mm256_unpackhi_pd(weights, weights), _mm256_sub_pd(y_high, y_low)));
  const __m128d first = _mm256_castpd256_pd128(planes), second = _mm256_extractf128_pd(planes, 1);
  const __m128d z_low = _mm_unpacklo_pd(first, second), z_high = _mm_unpackhi_pd(first, second);
  const __m128d z_weight =
      _mm_unpacklo_pd(_mm256_extractf128_pd(of_a.weight, 1), _mm256_extractf128_pd(of_b.weight, 1));
  return _mm_add_pd(z_low, _mm_mul_pd(z_weight, _mm_sub_pd(z_high, z_low)));
}

/// The same of one point.
[[gnu::noinline]] LENTRAY_AVX2 double solid_noise_avx2(double x, double y, double z) {
  const __m256d origin = _mm256_set1_pd(kSolidOrigin);
  const Place at(_mm256_add_pd(_mm256_set_pd(z, z, y, x), origin));
  if (!at.is_known()) [[unlikely]] {
    if (!is_near(at.point)) return solid_noise_portable({x, y, z});
    at.known.fill(at.cell);
  }
  const AlongX of = along_x(at);
  const __m128d y_low = _mm256_castpd256_pd128(of.value), y_high = _mm256_extractf128_pd(of.value, 1);
  const __m128d y_weight = _mm256_castpd256_pd128(_mm256_unpackhi_pd(of.weight, of.weight));
  const __m128d planes = _mm_add_pd(y_low, _mm_mul_pd(y_weight, _mm_sub_pd(y_high, y_low)));
  const double first = _mm_cvtsd_f64(planes), second = _mm_cvtsd_f64(_mm_unpackhi_pd(planes, planes));
  return first + _mm_cvtsd_f64(_mm256_extractf128_pd(of.weight, 1)) * (second - first);
}

}  // namespace

double solid_noise(double x, double y, double z) {
  return has_avx2() ? solid_noise_avx2(x, y, z) : solid_noise_portable({x, y, z});
}

NoisePair solid_noise(NoisePair x, NoisePair y, NoisePair z) {
  if (has_avx2()) return solid_pair_avx2(x, y, z);
  const double first = solid_noise_portable({x[0], y[0], z[0]});
  return NoisePair{first, solid_noise_portable({x[1], y[1], z[1]})};
}

}  // namespace lentray::core
