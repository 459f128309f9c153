// What noise.cpp and lattice.cpp share: the generator of their tables, the range, and the lattice noise
// of generators 1 and 2.
#pragma once

#include <algorithm>
#include <cstdint>

#include "core/base/simd.h"
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

LENTRAY_AVX2 inline Double2 in_range(Double2 value, int generator) {
  Double2 sum = value + 0.5;
  if (generator == 3) sum = 0.5 * (1.59 * value + 0.985);
  if (generator == 2) sum = (value + 1.05242) * 0.48985582;
  return simd::min(simd::double2(1.0), simd::max(Double2{}, sum));
}

/// The cell of a negative number: less 1 - kCellEpsilon, without its fraction.
inline constexpr double kCellEpsilon = 1e-10;
/// Added to what is hashed.
inline constexpr int kLatticeOrigin = 10000;

/// Beyond, cells are not counted in 32 bits.
inline constexpr double kFarCell = 1e9;

LENTRAY_AVX2 inline bool is_near(Double4 p) {
  const Double4 size = simd::abs(p);
  return simd::signs(size < kFarCell) == 15;
}

LENTRAY_AVX2 inline Double4 s_curve(Double4 t) {
  const Double4 slope = 3.0 - 2.0 * t;
  return t * t * slope;
}

/// Where a cell of x, y, z may be kept, before it is taken modulo the number of places; neighbours have different ones.
LENTRAY_AVX2 inline std::size_t lattice_slot(Int4 cell) {
  const std::uint64_t both = simd::packed_sums(cell);
  return both + (both >> 32);
}

/// Noise of generator 1 or 2 at a point, 0..1.
double lattice_noise(double x, double y, double z, int generator);
/// The same at two points.
NoisePair lattice_noise(NoisePair x, NoisePair y, NoisePair z, int generator);
/// To the bit the same where the coordinate number `axis` is 0; u and v are the two others.
double lattice_noise_in_plane(int axis, double u, double v, int generator);
NoisePair lattice_noise_in_plane(int axis, NoisePair u, NoisePair v, int generator);

}  // namespace lentray::core
