#include "core/noise/lattice.h"

#include <array>
#include <utility>

#include "core/base/thread_table.h"
#include "core/noise/lattice_cell.h"

namespace lentray::core {
namespace {

LatticeHashTable make_hash_table() {
  LatticeHashTable table{};
  for (int i = 0; i < kLattice; ++i)
    table[static_cast<std::size_t>(i)] = static_cast<std::uint16_t>(i);
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

/// The four gradients of a layer of a cell along z: the halves of their first numbers, then their second,
/// third and fourth numbers.
struct Layer {
  Double4 alone, x, y, z;
};
struct Layers {
  Layer near, far;
};

[[gnu::always_inline]] LENTRAY_AVX2 inline Layers layers_of(Int4 cell) {
  const Int4 place = (cell + kLatticeOrigin) & (kLattice - 1);
  const int x = place[0], y = place[1], z = place[2];
  const auto hash = [](int i) { return static_cast<int>(kLatticeHash[static_cast<unsigned>(i)]); };
  const int low = hash(x), high = hash(x + 1);
  const int columns[4] = {hash(low ^ y), hash(high ^ y), hash(low ^ (y + 1)), hash(high ^ (y + 1))};
  const auto layer = [&](int of_z) LENTRAY_AVX2 {
    const auto gradient = [&](int column) LENTRAY_AVX2 {
      return simd::double4_at(
          &kNoiseGradients[kLatticeHash[static_cast<unsigned>(columns[column] ^ of_z)] & 0xFFu]);
    };
    const Double4 a = gradient(0), b = gradient(1), c = gradient(2), d = gradient(3);
    const Double4 ab = simd::shuffled<0, 4, 2, 6>(a, b), ab_odd = simd::shuffled<1, 5, 3, 7>(a, b);
    const Double4 cd = simd::shuffled<0, 4, 2, 6>(c, d), cd_odd = simd::shuffled<1, 5, 3, 7>(c, d);
    return Layer{simd::shuffled<0, 1, 4, 5>(ab, cd) * 0.5,
                 simd::shuffled<0, 1, 4, 5>(ab_odd, cd_odd), simd::shuffled<2, 3, 6, 7>(ab, cd),
                 simd::shuffled<2, 3, 6, 7>(ab_odd, cd_odd)};
  };
  return {layer(z), layer(z + 1)};
}

/// A cell of the lattice as its corners weigh in.
struct KnownCell {
  alignas(32) double layers[2][4][4];
  alignas(16) std::array<int, 4> index{};  ///< along x, y, z, and 1; of none the last is another

  [[gnu::always_inline]] LENTRAY_AVX2 void set(Int4 of, const Layers& made) {
    const auto keep = [](double(&to)[4][4], const Layer& layer) LENTRAY_AVX2 {
      simd::store(to[0], layer.alone);
      simd::store(to[1], layer.x);
      simd::store(to[2], layer.y);
      simd::store(to[3], layer.z);
    };
    simd::store(index.data(), of);
    keep(layers[0], made.near);
    keep(layers[1], made.far);
  }
};

/// Those asked for lately: a search for a surface, or a picture's next pixel, asks for the same again.
constexpr std::size_t kKnownCells = 2048;
using KnownCells = std::array<KnownCell, kKnownCells>;

/// A point, and the cell it lies in.
struct Place {
  Double4 point;     ///< x, y, z, 1
  Int4 cell;         ///< of it: unlike that of all cells kept, where it is beyond them
  KnownCell& known;  ///< it, or one to be filled

  LENTRAY_AVX2 explicit Place(Double4 p) : Place(p, simd::truncated(below(p))) {}
  LENTRAY_AVX2 bool is_known() const {
    return simd::are_same(cell, simd::int4_at(known.index.data()));
  }

 private:
  LENTRAY_AVX2 Place(Double4 p, Int4 c)
      : point(p), cell(c), known(table_of_thread<KnownCells>()[lattice_slot(c) % kKnownCells]) {}
  LENTRAY_AVX2 static Double4 below(Double4 p) {
    return simd::chosen(p, p - (1.0 - kCellEpsilon), p);
  }
};

/// What the eight corners of a cell give, in the order of for_corners.
struct CornerValues {
  Double4 first, last;
};

[[gnu::always_inline]] LENTRAY_AVX2 inline CornerValues corner_values(Double4 point, Int4 cell,
                                                                      const Layers& layers) {
  const Double4 near = point - simd::widened(cell);
  const Double4 far = near - 1.0;
  const Double4 weight_far = s_curve(near), weight_near = 1.0 - weight_far;
  const Double4 xz = simd::shuffled<0, 4, 2, 6>(near, far),
                only_y = simd::shuffled<1, 5, 3, 7>(near, far);
  const Double4 x = simd::shuffled<0, 1, 0, 1>(xz), y = simd::shuffled<0, 0, 1, 1>(only_y);
  const Double4 weight_xz = simd::shuffled<0, 4, 2, 6>(weight_near, weight_far);
  const Double4 weight_y = simd::shuffled<1, 5, 3, 7>(weight_near, weight_far);
  const Double4 weight_xy =
      simd::shuffled<0, 1, 0, 1>(weight_xz) * simd::shuffled<0, 0, 1, 1>(weight_y);
  const auto layer = [&](const Layer& g, Double4 z, Double4 weight) LENTRAY_AVX2 {
    Double4 sum = g.alone + g.x * x;
    sum += g.y * y;
    sum += g.z * z;
    return weight_xy * weight * sum;
  };
  return {layer(layers.near, simd::shuffled<2, 2, 2, 2>(xz), simd::shuffled<2, 2, 2, 2>(weight_xz)),
          layer(layers.far, simd::shuffled<3, 3, 3, 3>(xz), simd::shuffled<3, 3, 3, 3>(weight_xz))};
}
[[gnu::always_inline]] LENTRAY_AVX2 inline CornerValues corner_values(const Place& at) {
  const auto layer = [](const double(&g)[4][4]) LENTRAY_AVX2 {
    return Layer{simd::double4_at(g[0]), simd::double4_at(g[1]), simd::double4_at(g[2]),
                 simd::double4_at(g[3])};
  };
  return corner_values(at.point, at.cell, {layer(at.known.layers[0]), layer(at.known.layers[1])});
}

[[gnu::always_inline]] LENTRAY_AVX2 inline double sum_of(const CornerValues& values) {
  double sum = 0.0;
  const auto add = [&](Double4 four) LENTRAY_AVX2 {
    const Double2 first = simd::first_half(four), second = simd::last_half(four);
    sum += first[0];
    sum += first[1];
    sum += second[0];
    sum += second[1];
  };
  add(values.first);
  add(values.last);
  return sum;
}

/// A cell is kept when it is asked for a second time: fine octaves go through cells that never are.
/// The point comes in halves: after a function that gets 32 bytes as one the compiler does not clear the
/// registers' upper halves, and what follows it waits for them.
[[gnu::noinline]] LENTRAY_AVX2 double in_new_cell(Double2 first, Double2 last, Int4 cell,
                                                  KnownCell& known, int generator) {
  const Double4 point = simd::joined(first, last);
  if (!is_near(point))
    return in_range(lattice_noise_portable({first[0], first[1], last[0]}), generator);
  const Layers layers = layers_of(cell);
  const Int4 once = cell + Int4{0, 0, 0, 1};
  if (simd::are_same(once, simd::int4_at(known.index.data())))
    known.set(cell, layers);
  else
    simd::store(known.index.data(), once);
  return in_range(sum_of(corner_values(point, cell, layers)), generator);
}

/// lattice_noise_portable, to the bit, in range. Calls nothing where the cell is known.
[[gnu::noinline]] LENTRAY_AVX2 double lattice_noise_avx2(double x, double y, double z,
                                                         int generator) {
  const Place place(Double4{x, y, z, 1.0});
  if (!place.is_known()) [[unlikely]]
    return in_new_cell(Double2{x, y}, Double2{z, 1.0}, place.cell, place.known, generator);
  return in_range(sum_of(corner_values(place)), generator);
}

[[gnu::noinline]] LENTRAY_AVX2 NoisePair one_by_one(NoisePair x, NoisePair y, NoisePair z,
                                                    int generator) {
  const double first = lattice_noise_avx2(x[0], y[0], z[0], generator);
  return NoisePair{first, lattice_noise_avx2(x[1], y[1], z[1], generator)};
}

[[gnu::noinline]] LENTRAY_AVX2 NoisePair lattice_pair_avx2(NoisePair x, NoisePair y, NoisePair z,
                                                           int generator) {
  const Double2 one = simd::double2(1.0);
  const Place place(simd::joined(simd::shuffled<0, 2>(x, y), simd::shuffled<0, 2>(z, one)));
  const Place other(simd::joined(simd::shuffled<1, 3>(x, y), simd::shuffled<1, 3>(z, one)));
  if (!place.is_known() || !other.is_known()) [[unlikely]]
    return one_by_one(x, y, z, generator);
  const CornerValues a = corner_values(place), b = corner_values(other);
  Double2 sum{};
  const auto add = [&](Double4 of_a, Double4 of_b) LENTRAY_AVX2 {
    const Double4 even = simd::shuffled<0, 4, 2, 6>(of_a, of_b),
                  odd = simd::shuffled<1, 5, 3, 7>(of_a, of_b);
    sum += simd::first_half(even);
    sum += simd::first_half(odd);
    sum += simd::last_half(even);
    sum += simd::last_half(odd);
  };
  add(a.first, b.first);
  add(a.last, b.last);
  return in_range(sum, generator);
}

}  // namespace

double lattice_noise(double x, double y, double z, int generator) {
  return has_avx2() ? lattice_noise_avx2(x, y, z, generator)
                    : in_range(lattice_noise_portable({x, y, z}), generator);
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
