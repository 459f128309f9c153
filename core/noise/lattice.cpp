#include "core/noise/lattice.h"

#include <array>
#include <utility>

#include "core/noise/lattice_cell.h"

namespace lentray::core {
namespace {

LatticeHashTable make_hash_table() {
  LatticeHashTable table{};
  for (int i = 0; i < kLattice; ++i) table[static_cast<std::size_t>(i)] = static_cast<std::uint16_t>(i);
  TableRandom random(0);
  for (int i = kLattice - 1; i >= 0; --i) {
    std::swap(table[static_cast<std::size_t>(i)],
              table[static_cast<std::size_t>(random.next() % kLattice)]);
  }
  std::copy_n(table.begin(), kLattice, table.begin() + kLattice);
  return table;
}

}  // namespace

const LatticeHashTable kLatticeHash = make_hash_table();

namespace {

double lattice_noise_portable(const Vec3& point) {
  const LatticeCell cell(point);
  double sum = 0.0;
  for_corners(cell, [&](const double* g, double weight, double x, double y, double z) {
    sum += weight * corner(g, x, y, z);
  });
  return sum;
}

/// A cell of the lattice as its corners weigh in: a layer along z has the halves of the first numbers
/// of its four gradients, then their second, third and fourth numbers.
struct KnownCell {
  alignas(32) double layers[2][4][4];
  alignas(16) std::array<int, 4> index{};  ///< along x, y, z, and 1; of none the last is 0

  LENTRAY_AVX2 void fill(__m128i of);
};

[[gnu::noinline]] LENTRAY_AVX2 void KnownCell::fill(__m128i of) {
  _mm_store_si128(reinterpret_cast<__m128i*>(index.data()), of);
  const auto place = [&](int axis) { return (index[static_cast<std::size_t>(axis)] + kLatticeOrigin) & (kLattice - 1); };
  const auto hash = [](int i) { return static_cast<int>(kLatticeHash[static_cast<unsigned>(i)]); };
  const int x = place(0), y = place(1), z = place(2), low = hash(x), high = hash(x + 1);
  const int columns[4] = {hash(low ^ y), hash(high ^ y), hash(low ^ (y + 1)), hash(high ^ (y + 1))};
  for (int layer = 0; layer < 2; ++layer) {
    const auto gradient = [&](int column) LENTRAY_AVX2 {
      return _mm256_loadu_pd(&kNoiseGradients[kLatticeHash[static_cast<unsigned>(columns[column] ^ (z + layer))] & 0xFFu]);
    };
    const __m256d a = gradient(0), b = gradient(1), c = gradient(2), d = gradient(3);
    const __m256d ab = _mm256_unpacklo_pd(a, b), ab_odd = _mm256_unpackhi_pd(a, b);
    const __m256d cd = _mm256_unpacklo_pd(c, d), cd_odd = _mm256_unpackhi_pd(c, d);
    double(&to)[4][4] = layers[layer];
    _mm256_store_pd(to[0], _mm256_mul_pd(_mm256_permute2f128_pd(ab, cd, 0x20), _mm256_set1_pd(0.5)));
    _mm256_store_pd(to[1], _mm256_permute2f128_pd(ab_odd, cd_odd, 0x20));
    _mm256_store_pd(to[2], _mm256_permute2f128_pd(ab, cd, 0x31));
    _mm256_store_pd(to[3], _mm256_permute2f128_pd(ab_odd, cd_odd, 0x31));
  }
}

/// Those asked for lately: a search for a surface, or a picture's next pixel, asks for the same again.
constexpr std::size_t kKnownCells = 2048;
thread_local constinit std::array<KnownCell, kKnownCells> t_cells{};

/// A point, and the cell it lies in.
struct Place {
  __m256d point;     ///< x, y, z, 1
  __m128i cell;      ///< of it: unlike that of all cells kept, where it is beyond them
  KnownCell& known;  ///< it, or one to be filled

  LENTRAY_AVX2 explicit Place(__m256d p) : Place(p, _mm256_cvttpd_epi32(below(p))) {}
  LENTRAY_AVX2 bool is_known() const {
    const __m128i same = _mm_cmpeq_epi32(cell, _mm_load_si128(reinterpret_cast<const __m128i*>(known.index.data())));
    return _mm_movemask_epi8(same) == 0xFFFF;
  }
  /// False where the point is beyond cells.
  LENTRAY_AVX2 bool make_known() const {
    if (is_known()) return true;
    if (!is_near(point)) return false;
    known.fill(cell);
    return true;
  }

 private:
  LENTRAY_AVX2 Place(__m256d p, __m128i c) : point(p), cell(c), known(t_cells[lattice_slot(c) % kKnownCells]) {}
  LENTRAY_AVX2 static __m256d below(__m256d p) {
    return _mm256_blendv_pd(p, _mm256_sub_pd(p, _mm256_set1_pd(1.0 - kCellEpsilon)), p);
  }
};

/// What the eight corners of a known cell give, in the order of for_corners.
struct CornerValues {
  __m256d first, last;
};

[[gnu::always_inline]] LENTRAY_AVX2 inline CornerValues corner_values(const Place& at) {
  const __m256d near = _mm256_sub_pd(at.point, _mm256_cvtepi32_pd(at.cell));
  const __m256d far = _mm256_sub_pd(near, _mm256_set1_pd(1.0));
  const __m256d weight_far = s_curve(near), weight_near = _mm256_sub_pd(_mm256_set1_pd(1.0), weight_far);
  const __m256d xz = _mm256_unpacklo_pd(near, far), only_y = _mm256_unpackhi_pd(near, far);
  const __m256d x = _mm256_permute2f128_pd(xz, xz, 0), y = _mm256_permute4x64_pd(only_y, 0x50);
  const __m256d weight_xz = _mm256_unpacklo_pd(weight_near, weight_far);
  const __m256d weight_y = _mm256_unpackhi_pd(weight_near, weight_far);
  const __m256d weight_xy =
      _mm256_mul_pd(_mm256_permute2f128_pd(weight_xz, weight_xz, 0), _mm256_permute4x64_pd(weight_y, 0x50));
  const auto layer = [&](const double(&g)[4][4], __m256d z, __m256d weight) LENTRAY_AVX2 {
    __m256d sum = _mm256_add_pd(_mm256_load_pd(g[0]), _mm256_mul_pd(_mm256_load_pd(g[1]), x));
    sum = _mm256_add_pd(sum, _mm256_mul_pd(_mm256_load_pd(g[2]), y));
    sum = _mm256_add_pd(sum, _mm256_mul_pd(_mm256_load_pd(g[3]), z));
    return _mm256_mul_pd(_mm256_mul_pd(weight_xy, weight), sum);
  };
  return {layer(at.known.layers[0], _mm256_permute4x64_pd(xz, 0xAA), _mm256_permute4x64_pd(weight_xz, 0xAA)),
          layer(at.known.layers[1], _mm256_permute4x64_pd(xz, 0xFF), _mm256_permute4x64_pd(weight_xz, 0xFF))};
}

/// lattice_noise_portable, to the bit, in range. Calls nothing where the cell is known.
LENTRAY_AVX2 double lattice_noise_avx2(double x, double y, double z, int generator);

[[gnu::noinline]] LENTRAY_AVX2 double in_new_cell(double x, double y, double z, int generator) {
  if (!Place(_mm256_set_pd(1.0, z, y, x)).make_known()) return in_range(lattice_noise_portable({x, y, z}), generator);
  return lattice_noise_avx2(x, y, z, generator);
}

[[gnu::noinline]] LENTRAY_AVX2 double lattice_noise_avx2(double x, double y, double z, int generator) {
  const Place place(_mm256_set_pd(1.0, z, y, x));
  if (!place.is_known()) [[unlikely]] return in_new_cell(x, y, z, generator);
  const CornerValues values = corner_values(place);
  double sum = 0.0;
  const auto add = [&](__m256d four) LENTRAY_AVX2 {
    const __m128d first = _mm256_castpd256_pd128(four), second = _mm256_extractf128_pd(four, 1);
    sum += _mm_cvtsd_f64(first);
    sum += _mm_cvtsd_f64(_mm_unpackhi_pd(first, first));
    sum += _mm_cvtsd_f64(second);
    sum += _mm_cvtsd_f64(_mm_unpackhi_pd(second, second));
  };
  add(values.first);
  add(values.last);
  return in_range(sum, generator);
}

[[gnu::noinline]] LENTRAY_AVX2 NoisePair one_by_one(NoisePair x, NoisePair y, NoisePair z, int generator) {
  const double first = lattice_noise_avx2(x[0], y[0], z[0], generator);
  return NoisePair{first, lattice_noise_avx2(x[1], y[1], z[1], generator)};
}

[[gnu::noinline]] LENTRAY_AVX2 NoisePair lattice_pair_avx2(NoisePair x, NoisePair y, NoisePair z, int generator) {
  const __m128d one = _mm_set1_pd(1.0);
  const Place place(_mm256_set_m128d(_mm_unpacklo_pd(z, one), _mm_unpacklo_pd(x, y)));
  const Place other(_mm256_set_m128d(_mm_unpackhi_pd(z, one), _mm_unpackhi_pd(x, y)));
  if (!place.is_known() || !other.is_known()) [[unlikely]] return one_by_one(x, y, z, generator);
  const CornerValues a = corner_values(place), b = corner_values(other);
  __m128d sum = _mm_setzero_pd();
  const auto add = [&](__m256d of_a, __m256d of_b) LENTRAY_AVX2 {
    const __m256d even = _mm256_unpacklo_pd(of_a, of_b), odd = _mm256_unpackhi_pd(of_a, of_b);
    sum = _mm_add_pd(sum, _mm256_castpd256_pd128(even));
    sum = _mm_add_pd(sum, _mm256_castpd256_pd128(odd));
    sum = _mm_add_pd(sum, _mm256_extractf128_pd(even, 1));
    sum = _mm_add_pd(sum, _mm256_extractf128_pd(odd, 1));
  };
  add(a.first, b.first);
  add(a.last, b.last);
  return in_range(sum, generator);
}

}  // namespace

double lattice_noise(double x, double y, double z, int generator) {
  return has_avx2() ? lattice_noise_avx2(x, y, z, generator) : in_range(lattice_noise_portable({x, y, z}), generator);
}

NoisePair lattice_noise(NoisePair x, NoisePair y, NoisePair z, int generator) {
  if (has_avx2()) return lattice_pair_avx2(x, y, z, generator);
  const double first = lattice_noise(x[0], y[0], z[0], generator);
  return NoisePair{first, lattice_noise(x[1], y[1], z[1], generator)};
}

unsigned lattice_hash(int x, int y, int z) {
  const auto at = [](int i) { return static_cast<int>(kLatticeHash[static_cast<std::size_t>(i)]); };
  return static_cast<unsigned>(at(at(at(x & 0xFFF) ^ (y & 0xFFF)) ^ (z & 0xFFF)));
}

}  // namespace lentray::core
