// Directions all around a point, evenly spread: those of a spiral whose turns are a golden angle apart.
// World space, unit. Not thread-safe: it has a place.
// Source: Vogel, Mathematical Biosciences 44, 1979, brought to the sphere by Archimedes' hat-box theorem.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "core/base/vec3.h"
#include "core/numeric/radical_inverse.h"

namespace lentray::core {

/// Where a spiral begins.
struct SpiralStart {
  double height, turn;  ///< in [0, 1)
};
/// Any two keys' starts are as if random. Of small numbers, a column in the lower half of the key and a row
/// in the upper one, those side by side are as different as can be: blocks of pixels have little noise.
inline SpiralStart spiral_start(std::uint64_t key) {
  // Morton's order, in which each square block of 2^n pixels is a run.
  std::uint64_t place = 0;
  for (unsigned bit = 0; bit < 32; ++bit) {
    place |= ((key >> bit & 1u) | (key >> (bit + 32) & 1u) << 1) << 2 * bit;
  }
  return {radical_inverse(place, 2), radical_inverse(place, 3)};
}

class SphereDirections {
 public:
  /// Where the start is random, all directions are equally likely.
  SphereDirections(int count, const SpiralStart& start)
      : m_step(2.0 / count), m_height(1.0 - m_step * start.height),
        m_cosine(std::cos(2.0 * std::numbers::pi * start.turn)),
        m_sine(std::sin(2.0 * std::numbers::pi * start.turn)) {}
  Vec3 next() {
    const double around = std::sqrt(std::max(0.0, 1.0 - m_height * m_height));
    const Vec3 direction(around * m_cosine, m_height, around * m_sine);
    m_height -= m_step;
    const double cosine = m_cosine * kCosine - m_sine * kSine;
    m_sine = m_sine * kCosine + m_cosine * kSine;
    m_cosine = cosine;
    return direction;
  }

 private:
  static inline const double kGoldenAngle = 2.0 * std::numbers::pi * (2.0 - std::numbers::phi);
  static inline const double kCosine = std::cos(kGoldenAngle), kSine = std::sin(kGoldenAngle);
  double m_step, m_height, m_cosine, m_sine;
};

}  // namespace lentray::core
