#include "core/noise/noise.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

#include "core/noise/lattice.h"
#include "core/noise/solid_noise.h"

namespace lentray::core {
namespace {

/// In 0..1: one for each value of lattice_hash(), and two more for the last.
const std::vector<double> kRandoms = [] {
  std::mt19937 generator;
  std::vector<double> values(4096 + 2);
  for (double& value : values) value = static_cast<double>(generator()) / 4294967296.0;
  return values;
}();

}  // namespace

double noise(double x, double y, double z, int generator) {
  if (generator != 3) return lattice_noise(x, y, z, generator);
  return in_range(solid_noise(x, y, z), 3);
}

NoisePair noise(NoisePair x, NoisePair y, NoisePair z, int generator) {
  if (generator != 3) return lattice_noise(x, y, z, generator);
  const NoisePair value = solid_noise(x, y, z);
  const double first = in_range(value[0], 3);
  return NoisePair{first, in_range(value[1], 3)};
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

double noise_in_plane(int axis, double u, double v, int generator) {
  return in_plane(axis, u, v, generator);
}

NoisePair noise_in_plane(int axis, NoisePair u, NoisePair v, int generator) {
  return in_plane(axis, u, v, generator);
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

double cycloidal(double value) {
  return std::sin((value - std::trunc(value)) * (2.0 * std::numbers::pi));
}

double triangle_wave(double value) {
  const double offset =
      value >= 0.0 ? value - std::floor(value) : value + 1.0 + std::floor(std::fabs(value));
  return offset >= 0.5 ? 2.0 * (1.0 - offset) : 2.0 * offset;
}

Vec3 cell_randoms(int x, int y, int z) {
  const double* const from = &kRandoms[lattice_hash(x, y, z)];
  return {from[0], from[1], from[2]};
}

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
