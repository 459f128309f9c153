// Van der Corput's sequences: evenly spread numbers in [0, 1), of which two bases make Halton's in the square.
// Pure.
// Source: Halton, Numerische Mathematik 2, 1960.
#pragma once

#include <cstdint>

namespace lentray::core {

/// The digits of a number, mirrored at the point.
inline double radical_inverse(std::uint64_t number, unsigned base) {
  double result = 0.0, place = 1.0 / base;
  for (; number != 0; number /= base) {
    result += static_cast<double>(number % base) * place;
    place /= base;
  }
  return result;
}

}  // namespace lentray::core
