// Solid noise and what is built on it. Textures are designed on its very values. Pure functions of the point
// (pattern space); tables are made once, then only read.
// Source: reference manual 3.7, "Noise Generators", "Turbulence"; constants looked up, values
// compared with stock by tests/image/patterns_test.cpp.
#pragma once

#include <cstddef>
#include <vector>

#include "core/base/vec3.h"

namespace lentray::core {

struct Turbulence {
  Vec3 amount;
  int octaves = 6;
  double lambda = 2.0, omega = 0.5;
};

/// 0..1. Generator 1: the original; 2: range corrected; 3: Perlin's.
/// By value: a point that was just written part by part and is read whole holds the processor up.
double noise(double x, double y, double z, int generator);
/// The same at two points side by side, in less time than one after the other.
using NoisePair [[gnu::vector_size(16)]] = double;
NoisePair noise(NoisePair x, NoisePair y, NoisePair z, int generator);
/// Where the coordinate number `axis` is 0, and u and v are the two others: noise's bits in less time.
double noise_in_plane(int axis, double u, double v, int generator);
NoisePair noise_in_plane(int axis, NoisePair u, NoisePair v, int generator);
inline double noise(const Vec3& p, int generator) { return noise(p.x, p.y, p.z, generator); }
/// A vector of noise, about -1..1 each; the same for all generators.
Vec3 vector_noise(const Vec3& point);
/// Octaves of noise; the amount is not applied.
double turbulence(const Vec3& point, const Turbulence& turbulence, int generator);
Vec3 vector_turbulence(const Vec3& point, const Turbulence& turbulence);

/// Sine of period 1.
double cycloidal(double value);
/// 0..1..0 of period 1.
double triangle_wave(double value);

/// The table of 4096 numbers in random order, chained over three lattice coordinates.
unsigned lattice_hash(int x, int y, int z);
/// Three random numbers in 0..1 of a cell of the lattice.
Vec3 cell_randoms(int x, int y, int z);

/// Sources of ripples and waves: unit vectors and frequencies; global_settings sets the number.
struct WaveSource {
  Vec3 position;
  double frequency = 1.0;
};
std::vector<WaveSource> wave_sources(int count);

}  // namespace lentray::core
