#include "core/pattern/noise.h"

#include <immintrin.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <cstdint>
#include <numbers>
#include <random>

#include "core/base/processor.h"
#include "core/pattern/noise_table.h"

namespace lentray::core {
namespace {

constexpr double kEpsilon = 1e-10;
constexpr int kLattice = 4096;
constexpr int kLatticeOrigin = 10000;
constexpr double kSolidOrigin = 10000000.023157213;

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

/// 0..4095 shuffled, twice in a row so that index + 1 needs no wrap.
using HashTable = std::array<std::uint16_t, 2 * kLattice>;

HashTable make_hash_table() {
  HashTable table{};
  for (int i = 0; i < kLattice; ++i) table[static_cast<std::size_t>(i)] = static_cast<std::uint16_t>(i);
  TableRandom random(0);
  for (int i = kLattice - 1; i >= 0; --i) {
    std::swap(table[static_cast<std::size_t>(i)],
              table[static_cast<std::size_t>(random.next() % kLattice)]);
  }
  std::copy_n(table.begin(), kLattice, table.begin() + kLattice);
  return table;
}

const HashTable kHash = make_hash_table();

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

const std::vector<double> kRandoms = [] {
  std::mt19937 generator;
  std::vector<double> values(32768);
  for (double& value : values) value = static_cast<double>(generator()) / 4294967296.0;
  return values;
}();

inline double s_curve(double t) { return t * t * (3.0 - 2.0 * t); }

/// One axis of a lattice cell: its index, the point's place in it and the two weights.
struct CellAxis {
  int index;
  double near, far;          ///< from the lower and the upper corner
  double weight_near, weight_far;

  explicit CellAxis(double x) {
    const double below = x >= 0.0 ? x : x - (1.0 - kEpsilon);
    // Beyond all cells, and for nan, what the processor makes of the conversion.
    const std::int64_t cell = std::fabs(below) < 9e18 ? static_cast<std::int64_t>(below)
                                                      : std::numeric_limits<std::int64_t>::min();
    index = static_cast<int>((cell + kLatticeOrigin) & (kLattice - 1));
    near = x - static_cast<double>(cell);
    far = near - 1.0;
    weight_far = s_curve(near);
    weight_near = 1.0 - weight_far;
  }
};

/// The eight corners of the cell a point lies in, with the gradients' place in the table.
struct Cell {
  CellAxis x, y, z;
  std::array<int, 4> columns;  ///< hashes of (x, y): bit 0 x, bit 1 y

  explicit Cell(const Vec3& p) : x(p.x), y(p.y), z(p.z) {
    for (int i = 0; i < 4; ++i) {
      const int a = kHash[static_cast<std::size_t>(x.index + (i & 1))];
      columns[static_cast<std::size_t>(i)] =
          kHash[static_cast<std::size_t>(a ^ (y.index + (i >> 1)))];
    }
  }
  const double* gradient(int column, int layer) const {
    const int hash = columns[static_cast<std::size_t>(column)] ^ (z.index + layer);
    return &kNoiseGradients[kHash[static_cast<std::size_t>(hash)] & 0xFFu];
  }
};

inline double corner(const double* g, double x, double y, double z) {
  return g[0] * 0.5 + g[1] * x + g[2] * y + g[3] * z;
}

/// Calls `visit(gradient, weight, x, y, z)` for the corners in the order 000, 100, 010, 110, 001 ...
/// Spelled out: as a loop it is not unrolled, and takes half as long again.
template <typename Visit>
inline void for_corners(const Cell& cell, Visit visit) {
  const auto one = [&](int column, int layer) {
    const bool far_x = column & 1, far_y = column & 2;
    const double weight = (far_x ? cell.x.weight_far : cell.x.weight_near) *
                          (far_y ? cell.y.weight_far : cell.y.weight_near) *
                          (layer ? cell.z.weight_far : cell.z.weight_near);
    visit(cell.gradient(column, layer), weight, far_x ? cell.x.far : cell.x.near,
          far_y ? cell.y.far : cell.y.near, layer ? cell.z.far : cell.z.near);
  };
  one(0, 0);
  one(1, 0);
  one(2, 0);
  one(3, 0);
  one(0, 1);
  one(1, 1);
  one(2, 1);
  one(3, 1);
}

double lattice_noise_portable(const Vec3& point) {
  const Cell cell(point);
  double sum = 0.0;
  for_corners(cell, [&](const double* g, double weight, double x, double y, double z) {
    sum += weight * corner(g, x, y, z);
  });
  return sum;
}

/// Weighted values of a layer's four corners, in the order of for_corners. `near` and `far` are
/// (0.5, x, y, z), `columns` the hashes of the four columns.
template <int kLayer>
LENTRAY_AVX2 inline __m256d corners_avx2(const int columns[4], int layer, __m256d near, __m256d far,
                                         __m256d weights, __m256d layer_weight) {
  constexpr int kZ = kLayer * 8;  // lanes of `far`: 2 x, 4 y, 8 z
  const auto gradient = [&](int column) LENTRAY_AVX2 {
    return _mm256_loadu_pd(&kNoiseGradients[kHash[static_cast<unsigned>(columns[column] ^ layer)] & 0xFFu]);
  };
  const __m256d a = _mm256_mul_pd(gradient(0), _mm256_blend_pd(near, far, kZ));
  const __m256d b = _mm256_mul_pd(gradient(1), _mm256_blend_pd(near, far, kZ | 2));
  const __m256d c = _mm256_mul_pd(gradient(2), _mm256_blend_pd(near, far, kZ | 4));
  const __m256d d = _mm256_mul_pd(gradient(3), _mm256_blend_pd(near, far, kZ | 6));
  const __m256d ab = _mm256_unpacklo_pd(a, b), ab_odd = _mm256_unpackhi_pd(a, b);
  const __m256d cd = _mm256_unpacklo_pd(c, d), cd_odd = _mm256_unpackhi_pd(c, d);
  __m256d sum = _mm256_add_pd(_mm256_permute2f128_pd(ab, cd, 0x20), _mm256_permute2f128_pd(ab_odd, cd_odd, 0x20));
  sum = _mm256_add_pd(sum, _mm256_permute2f128_pd(ab, cd, 0x31));
  sum = _mm256_add_pd(sum, _mm256_permute2f128_pd(ab_odd, cd_odd, 0x31));
  return _mm256_mul_pd(_mm256_mul_pd(weights, layer_weight), sum);
}

/// From what the noises give to 0..1.
inline double in_range(double value, int generator) {
  double sum = value + 0.5;
  if (generator == 3) sum = 0.5 * (1.59 * value + 0.985);
  if (generator == 2) sum = (value + 1.05242) * 0.48985582;
  return std::clamp(sum, 0.0, 1.0);
}

/// Beyond, cells are not counted in 32 bits.
constexpr double kFarCell = 1e9;

LENTRAY_AVX2 inline bool is_near(__m256d p) {
  const __m256d size = _mm256_andnot_pd(_mm256_set1_pd(-0.0), p);
  return _mm256_movemask_pd(_mm256_cmp_pd(size, _mm256_set1_pd(kFarCell), _CMP_LT_OQ)) == 15;
}

LENTRAY_AVX2 inline __m256d s_curve(__m256d t) {
  const __m256d slope = _mm256_sub_pd(_mm256_set1_pd(3.0), _mm256_mul_pd(_mm256_set1_pd(2.0), t));
  return _mm256_mul_pd(_mm256_mul_pd(t, t), slope);
}

/// lattice_noise_portable, to the bit, in range.
LENTRAY_AVX2 [[gnu::noinline]] double lattice_noise_avx2(double px, double py, double pz, int generator) {
  const __m256d p = _mm256_set_pd(pz, py, px, 0.0);
  if (!is_near(p)) return in_range(lattice_noise_portable({px, py, pz}), generator);
  const __m256d below = _mm256_blendv_pd(p, _mm256_sub_pd(p, _mm256_set1_pd(1.0 - kEpsilon)),
                                         _mm256_cmp_pd(p, _mm256_setzero_pd(), _CMP_LT_OQ));
  const __m128i cell = _mm256_cvttpd_epi32(below);
  __m256d near = _mm256_sub_pd(p, _mm256_cvtepi32_pd(cell));
  __m256d far = _mm256_sub_pd(near, _mm256_set1_pd(1.0));
  const __m256d weight_far = s_curve(near), weight_near = _mm256_sub_pd(_mm256_set1_pd(1.0), weight_far);
  near = _mm256_blend_pd(near, _mm256_set1_pd(0.5), 1);
  far = _mm256_blend_pd(far, _mm256_set1_pd(0.5), 1);
  const __m128i place = _mm_and_si128(_mm_add_epi32(cell, _mm_set1_epi32(kLatticeOrigin)),
                                      _mm_set1_epi32(kLattice - 1));
  const int x = _mm_extract_epi32(place, 1), y = _mm_extract_epi32(place, 2), z = _mm_extract_epi32(place, 3);
  const auto hash = [](int i) { return static_cast<int>(kHash[static_cast<unsigned>(i)]); };
  const int low = hash(x), high = hash(x + 1);
  const int columns[4] = {hash(low ^ y), hash(high ^ y), hash(low ^ (y + 1)), hash(high ^ (y + 1))};
  const __m256d xz = _mm256_unpackhi_pd(weight_near, weight_far), y_only = _mm256_unpacklo_pd(weight_near, weight_far);
  const __m256d weights = _mm256_mul_pd(_mm256_permute2f128_pd(xz, xz, 0), _mm256_permute4x64_pd(y_only, 0xFA));
  alignas(32) double values[8];
  _mm256_store_pd(values, corners_avx2<0>(columns, z, near, far, weights, _mm256_permute4x64_pd(xz, 0xAA)));
  _mm256_store_pd(values + 4, corners_avx2<1>(columns, z + 1, near, far, weights, _mm256_permute4x64_pd(xz, 0xFF)));
  double sum = 0.0;
  for (const double value : values) sum += value;
  return in_range(sum, generator);
}

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

/// solid_noise_portable, to the bit.
LENTRAY_AVX2 [[gnu::noinline]] double solid_noise_avx2(double px, double py, double pz) {
  const __m256d p = _mm256_set_pd(0.0, pz, py, px);
  if (!is_near(p)) return solid_noise_portable({px, py, pz});
  const __m256d t = _mm256_add_pd(p, _mm256_set1_pd(kSolidOrigin)), whole = _mm256_floor_pd(t);
  const __m256d near = _mm256_sub_pd(t, whole), far = _mm256_sub_pd(near, _mm256_set1_pd(1.0));
  const __m256d weight = s_curve(near);
  const __m128i mask = _mm_set1_epi32(SolidTables::kEntries - 1);
  const __m128i low = _mm_and_si128(_mm256_cvttpd_epi32(whole), mask);
  const __m128i high = _mm_and_si128(_mm_add_epi32(low, _mm_set1_epi32(1)), mask);
  const auto permuted = [](int i) { return kSolid.permutation[static_cast<std::size_t>(i)]; };
  const int i = permuted(_mm_cvtsi128_si32(low)), j = permuted(_mm_cvtsi128_si32(high));
  const int y0 = _mm_extract_epi32(low, 1), y1 = _mm_extract_epi32(high, 1);
  const int columns[4] = {permuted(i + y0), permuted(j + y0), permuted(i + y1), permuted(j + y1)};
  const int layers[2] = {_mm_extract_epi32(low, 2), _mm_extract_epi32(high, 2)};
  __m256d values[2];  // of the four columns
  for (int layer = 0; layer < 2; ++layer) {
    const __m256d z = layer == 0 ? near : far;
    const auto product = [&](int column, __m256d xy) LENTRAY_AVX2 {
      const Vec3& g = kSolid.gradients[static_cast<std::size_t>(columns[column] + layers[layer])];
      return _mm256_mul_pd(_mm256_loadu_pd(&g.x), _mm256_blend_pd(xy, z, 4));
    };
    const __m256d a = product(0, near), b = product(1, _mm256_blend_pd(near, far, 1));
    const __m256d c = product(2, _mm256_blend_pd(near, far, 2)), d = product(3, far);
    const __m256d ab = _mm256_unpacklo_pd(a, b), ab_odd = _mm256_unpackhi_pd(a, b);
    const __m256d cd = _mm256_unpacklo_pd(c, d), cd_odd = _mm256_unpackhi_pd(c, d);
    const __m256d sum = _mm256_add_pd(_mm256_permute2f128_pd(ab, cd, 0x20),
                                      _mm256_permute2f128_pd(ab_odd, cd_odd, 0x20));
    values[layer] = _mm256_add_pd(sum, _mm256_permute2f128_pd(ab, cd, 0x31));
  }
  // Along x for both layers: (y low: layers 0, 1; y high: layers 0, 1), then along y, then z.
  const __m256d x_low = _mm256_unpacklo_pd(values[0], values[1]), x_high = _mm256_unpackhi_pd(values[0], values[1]);
  const __m256d along_x = _mm256_add_pd(
      x_low, _mm256_mul_pd(_mm256_permute4x64_pd(weight, 0x00), _mm256_sub_pd(x_high, x_low)));
  const __m128d y_low = _mm256_castpd256_pd128(along_x), y_high = _mm256_extractf128_pd(along_x, 1);
  const __m128d y_weight = _mm256_castpd256_pd128(_mm256_permute4x64_pd(weight, 0x55));
  const __m128d planes = _mm_add_pd(y_low, _mm_mul_pd(y_weight, _mm_sub_pd(y_high, y_low)));
  const double first = _mm_cvtsd_f64(planes), second = _mm_cvtsd_f64(_mm_unpackhi_pd(planes, planes));
  return first + _mm256_cvtsd_f64(_mm256_permute4x64_pd(weight, 0xAA)) * (second - first);
}

}  // namespace

double noise(double x, double y, double z, int generator) {
  const bool avx2 = has_avx2();
  if (generator == 3) return in_range(avx2 ? solid_noise_avx2(x, y, z) : solid_noise_portable({x, y, z}), 3);
  return avx2 ? lattice_noise_avx2(x, y, z, generator) : in_range(lattice_noise_portable({x, y, z}), generator);
}

Vec3 vector_noise(const Vec3& point) {
  const Cell cell(point);
  Vec3 result;
  for_corners(cell, [&](const double* g, double weight, double x, double y, double z) {
    result += Vec3(corner(g, x, y, z), corner(g + 4, x, y, z), corner(g + 8, x, y, z)) * weight;
  });
  return result;
}

double turbulence(const Vec3& point, const Turbulence& turbulence, int generator) {
  // Generators above 1 have their range stretched here; only the first octave is clamped.
  double value = noise(point, generator);
  if (generator > 1) value = std::clamp(2.0 * value - 0.5, 0.0, 1.0);
  double scale = turbulence.lambda, weight = turbulence.omega;
  for (int octave = 2; octave <= turbulence.octaves; ++octave) {
    const double one = noise(point * scale, generator);
    value += weight * (generator > 1 ? 2.0 * one - 0.5 : one);
    scale *= turbulence.lambda;
    weight *= turbulence.omega;
  }
  return value;
}

Vec3 vector_turbulence(const Vec3& point, const Turbulence& turbulence) {
  Vec3 result = vector_noise(point);
  double scale = turbulence.lambda, weight = turbulence.omega;
  for (int octave = 2; octave <= turbulence.octaves; ++octave) {
    result += vector_noise(point * scale) * weight;
    scale *= turbulence.lambda;
    weight *= turbulence.omega;
  }
  return result;
}

double cycloidal(double value) {
  return std::sin((value - std::trunc(value)) * (2.0 * std::numbers::pi));
}

double triangle_wave(double value) {
  const double offset = value >= 0.0 ? value - std::floor(value)
                                     : value + 1.0 + std::floor(std::fabs(value));
  return offset >= 0.5 ? 2.0 * (1.0 - offset) : 2.0 * offset;
}

unsigned lattice_hash(int x, int y, int z) {
  const auto at = [](int i) { return static_cast<int>(kHash[static_cast<std::size_t>(i)]); };
  return static_cast<unsigned>(at(at(at(x & 0xFFF) ^ (y & 0xFFF)) ^ (z & 0xFFF)));
}

double lattice_random(std::size_t index) { return kRandoms[index % kRandoms.size()]; }

std::vector<WaveSource> wave_sources(int count) {
  std::vector<WaveSource> sources;
  TableRandom random(static_cast<std::uint32_t>(-560851967));
  for (int i = 0; i < count; ++i) {
    const Vec3 direction = normalized(vector_noise({static_cast<double>(i), 0.0, 0.0}));
    sources.push_back({direction, random.next() * 0.000030518509476 + 0.01});
  }
  return sources;
}

}  // namespace lentray::core
