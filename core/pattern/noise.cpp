#include "core/pattern/noise.h"

#include <immintrin.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <cstdint>
#include <numbers>
#include <random>

#include "core/pattern/noise_table.h"

namespace lentray::core {
namespace {

constexpr double kEpsilon = 1e-10;
constexpr int kLattice = 4096;
constexpr int kLatticeOrigin = 10000;

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
  std::array<Vec3, 2 * (kEntries + 1)> gradients{};

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

// Without fused operations: the values are stock's to the last bit.
#define LENTRAY_NOISE_AVX2 __attribute__((target("avx2")))

/// Weighted values of a layer's four corners, in the order of for_corners.
template <int kLayer>
LENTRAY_NOISE_AVX2 inline __m256d corners_avx2(const Cell& cell, __m256d near, __m256d far, __m256d weights) {
  constexpr int kZ = kLayer * 8;  // lanes of `far`: 2 x, 4 y, 8 z
  const __m256d a = _mm256_mul_pd(_mm256_loadu_pd(cell.gradient(0, kLayer)), _mm256_blend_pd(near, far, kZ));
  const __m256d b = _mm256_mul_pd(_mm256_loadu_pd(cell.gradient(1, kLayer)), _mm256_blend_pd(near, far, kZ | 2));
  const __m256d c = _mm256_mul_pd(_mm256_loadu_pd(cell.gradient(2, kLayer)), _mm256_blend_pd(near, far, kZ | 4));
  const __m256d d = _mm256_mul_pd(_mm256_loadu_pd(cell.gradient(3, kLayer)), _mm256_blend_pd(near, far, kZ | 6));
  const __m256d ab = _mm256_unpacklo_pd(a, b), ab_odd = _mm256_unpackhi_pd(a, b);
  const __m256d cd = _mm256_unpacklo_pd(c, d), cd_odd = _mm256_unpackhi_pd(c, d);
  __m256d sum = _mm256_add_pd(_mm256_permute2f128_pd(ab, cd, 0x20), _mm256_permute2f128_pd(ab_odd, cd_odd, 0x20));
  sum = _mm256_add_pd(sum, _mm256_permute2f128_pd(ab, cd, 0x31));
  sum = _mm256_add_pd(sum, _mm256_permute2f128_pd(ab_odd, cd_odd, 0x31));
  const double weight = kLayer ? cell.z.weight_far : cell.z.weight_near;
  return _mm256_mul_pd(_mm256_mul_pd(weights, _mm256_set1_pd(weight)), sum);
}

/// lattice_noise, to the bit.
LENTRAY_NOISE_AVX2 double lattice_noise_avx2(const Vec3& point) {
  const Cell cell(point);
  const CellAxis &x = cell.x, &y = cell.y;
  const __m256d near = _mm256_set_pd(cell.z.near, y.near, x.near, 0.5);
  const __m256d far = _mm256_set_pd(cell.z.far, y.far, x.far, 0.5);
  const __m256d weights =
      _mm256_mul_pd(_mm256_set_pd(x.weight_far, x.weight_near, x.weight_far, x.weight_near),
                    _mm256_set_pd(y.weight_far, y.weight_far, y.weight_near, y.weight_near));
  alignas(32) double values[8];
  _mm256_store_pd(values, corners_avx2<0>(cell, near, far, weights));
  _mm256_store_pd(values + 4, corners_avx2<1>(cell, near, far, weights));
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum;
}

double lattice_noise(const Vec3& point) {
  if (__builtin_cpu_supports("avx2") != 0) return lattice_noise_avx2(point);
  const Cell cell(point);
  double sum = 0.0;
  for_corners(cell, [&](const double* g, double weight, double x, double y, double z) {
    sum += weight * corner(g, x, y, z);
  });
  return sum;
}

/// One axis of the solid noise's cell; the offset keeps coordinates positive.
struct SolidAxis {
  int low, high;
  double near, far, weight;
  explicit SolidAxis(double x) {
    const double t = x + 10000000.023157213;
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

double solid_noise(const Vec3& p) {
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

}  // namespace

double noise(const Vec3& point, int generator) {
  double sum = 0.0;
  if (generator == 3) {
    sum = 0.5 * (1.59 * solid_noise(point) + 0.985);
  } else if (generator == 2) {
    sum = (lattice_noise(point) + 1.05242) * 0.48985582;
  } else {
    sum = lattice_noise(point) + 0.5;
  }
  return std::clamp(sum, 0.0, 1.0);
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
