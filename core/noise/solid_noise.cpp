#include "core/noise/solid_noise.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include "core/base/thread_table.h"
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
    const Vec3& g =
        kSolid.gradients[static_cast<std::size_t>(columns[column] + (layer ? z.high : z.low))];
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

  void fill(Int4 of);
};

[[gnu::noinline]] void KnownCell::fill(Int4 of) {
  simd::store(index.data(), of);
  const auto permuted = [](int i) { return kSolid.permutation[static_cast<std::size_t>(i)]; };
  const auto within = [](int i) { return i & (SolidTables::kEntries - 1); };
  const int i = permuted(within(index[0])), j = permuted(within(index[0] + 1));
  const int y[2] = {within(index[1]), within(index[1] + 1)},
            z[2] = {within(index[2]), within(index[2] + 1)};
  const int columns[4] = {permuted(i + y[0]), permuted(j + y[0]), permuted(i + y[1]),
                          permuted(j + y[1])};
  for (int layer = 0; layer < 2; ++layer) {
    for (int column = 0; column < 4; ++column) {
      const Vec3& g = kSolid.gradients[static_cast<std::size_t>(columns[column] + z[layer])];
      for (int axis = 0; axis < 3; ++axis) layers[layer][axis][column] = g[axis];
    }
  }
}

/// Those asked for lately, as for the lattice's.
constexpr std::size_t kKnownCells = 2048;
using KnownCells = std::array<KnownCell, kKnownCells>;

/// A point, and the cell it lies in.
struct Place {
  Double4 point;     ///< x, y, z moved, and anything
  Double4 whole;     ///< of it
  Int4 cell;         ///< x, y, z, and 1: unlike that of all cells kept, where it is beyond them
  KnownCell& known;  ///< where it is kept, if it is

  LENTRAY_AVX2 explicit Place(Double4 p) : Place(p, simd::floor(p)) {}
  LENTRAY_AVX2 bool is_known() const {
    return simd::are_same(cell, simd::int4_at(known.index.data()));
  }

 private:
  LENTRAY_AVX2 Place(Double4 p, Double4 w) : Place(p, w, cell_of(w)) {}
  LENTRAY_AVX2 Place(Double4 p, Double4 w, Int4 c)
      : point(p), whole(w), cell(c),
        known(table_of_thread<KnownCells>()[lattice_slot(c) % kKnownCells]) {}
  LENTRAY_AVX2 static Int4 cell_of(Double4 whole) {
    return simd::shuffled<0, 1, 2, 7>(simd::truncated(whole), simd::int4(1));
  }
};

/// Between the corners of a known cell along x: y low in both layers, y high in both; and the weights.
struct AlongX {
  Double4 value, weight;
};

[[gnu::always_inline]] LENTRAY_AVX2 inline AlongX along_x(const Place& at) {
  const Double4 near = at.point - at.whole, far = near - 1.0;
  const Double4 weight = s_curve(near);
  const Double4 xz = simd::shuffled<0, 4, 2, 6>(near, far),
                only_y = simd::shuffled<1, 5, 3, 7>(near, far);
  const Double4 x = simd::shuffled<0, 1, 0, 1>(xz), y = simd::shuffled<0, 0, 1, 1>(only_y);
  const auto layer = [&](const double(&g)[3][4], Double4 z) LENTRAY_AVX2 {
    const Double4 sum = x * simd::double4_at(g[0]) + y * simd::double4_at(g[1]);
    return sum + z * simd::double4_at(g[2]);
  };
  const Double4 low = layer(at.known.layers[0], simd::shuffled<2, 2, 2, 2>(xz));
  const Double4 high = layer(at.known.layers[1], simd::shuffled<3, 3, 3, 3>(xz));
  const Double4 x_low = simd::shuffled<0, 4, 2, 6>(low, high),
                x_high = simd::shuffled<1, 5, 3, 7>(low, high);
  const Double4 x_weight = simd::shuffled<0, 0, 0, 0>(weight);
  return {x_low + x_weight * (x_high - x_low), weight};
}

/// solid_noise_portable of both points, to the bit. Calls nothing where the cells are known.
[[gnu::noinline]] LENTRAY_AVX2 NoisePair solid_pair_avx2(NoisePair x, NoisePair y, NoisePair z);

[[gnu::noinline]] LENTRAY_AVX2 NoisePair in_new_cells(NoisePair x, NoisePair y, NoisePair z,
                                                      const Place& a, const Place& b) {
  const bool is_shared = &a.known == &b.known && !simd::are_same(a.cell, b.cell);
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
  const Double2 tx = x + kSolidOrigin, ty = y + kSolidOrigin, tz = z + kSolidOrigin;
  const Place a(simd::joined(simd::shuffled<0, 2>(tx, ty), simd::shuffled<0, 2>(tz)));
  const Place b(simd::joined(simd::shuffled<1, 3>(tx, ty), simd::shuffled<1, 3>(tz)));
  if (!a.is_known() || !b.is_known()) [[unlikely]]
    return in_new_cells(x, y, z, a, b);
  const AlongX of_a = along_x(a), of_b = along_x(b);
  const Double4 y_low = simd::shuffled<0, 1, 4, 5>(of_a.value, of_b.value);
  const Double4 y_high = simd::shuffled<2, 3, 6, 7>(of_a.value, of_b.value);
  const Double4 weights = simd::shuffled<0, 1, 4, 5>(of_a.weight, of_b.weight);
  const Double4 planes = y_low + simd::shuffled<1, 5, 3, 7>(weights) * (y_high - y_low);
  const Double2 first = simd::first_half(planes), second = simd::last_half(planes);
  const Double2 z_low = simd::shuffled<0, 2>(first, second),
                z_high = simd::shuffled<1, 3>(first, second);
  const Double2 z_weight =
      simd::shuffled<0, 2>(simd::last_half(of_a.weight), simd::last_half(of_b.weight));
  return z_low + z_weight * (z_high - z_low);
}

/// The same of one point.
[[gnu::noinline]] LENTRAY_AVX2 double solid_noise_avx2(double x, double y, double z) {
  const Place at(Double4{x, y, z, z} + kSolidOrigin);
  if (!at.is_known()) [[unlikely]] {
    if (!is_near(at.point)) return solid_noise_portable({x, y, z});
    at.known.fill(at.cell);
  }
  const AlongX of = along_x(at);
  const Double2 y_low = simd::first_half(of.value), y_high = simd::last_half(of.value);
  const Double2 y_weight = simd::first_half(simd::shuffled<1, 5, 3, 7>(of.weight));
  const Double2 planes = y_low + y_weight * (y_high - y_low);
  const double first = planes[0], second = planes[1];
  return first + simd::last_half(of.weight)[0] * (second - first);
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
