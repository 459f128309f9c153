#include "core/pattern/noise.h"

#include <immintrin.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

#include "core/pattern/lattice.h"

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

const std::vector<double> kRandoms = [] {
  std::mt19937 generator;
  std::vector<double> values(32768);
  for (double& value : values) value = static_cast<double>(generator()) / 4294967296.0;
  return values;
}();

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
[[gnu::noinline]] LENTRAY_AVX2 double solid_noise_avx2(double px, double py, double pz) {
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
  if (generator != 3) return lattice_noise(x, y, z, generator);
  return in_range(has_avx2() ? solid_noise_avx2(x, y, z) : solid_noise_portable({x, y, z}), 3);
}

NoisePair noise(NoisePair x, NoisePair y, NoisePair z, int generator) {
  if (generator != 3) return lattice_noise(x, y, z, generator);
  const double first = noise(x[0], y[0], z[0], generator);
  return NoisePair{first, noise(x[1], y[1], z[1], generator)};
}

namespace {

template <class Number>
Number in_plane(int axis, Number u, Number v, int generator) {
  if (generator != 3) return lattice_noise_in_plane(axis, u, v, generator);
  const Number zero{};
  if (axis == 0) return noise(zero, u, v, generator);
  return axis == 1 ? noise(u, zero, v, generator) : noise(u, v, zero, generator);
}

}  // namespace

double noise_in_plane(int axis, double u, double v, int generator) { return in_plane(axis, u, v, generator); }

NoisePair noise_in_plane(int axis, NoisePair u, NoisePair v, int generator) { return in_plane(axis, u, v, generator); }

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
