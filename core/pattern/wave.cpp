#include <cmath>

#include "core/pattern/noise.h"
#include "core/pattern/pattern.h"

namespace lentray::core {

double Wave::apply(double value) const {
  if (frequency != 0.0) {
    // Stock wraps a little above 1, so that a pattern that ends at 1 keeps its last colour.
    constexpr double kWrap = 1.00001;
    value = value * frequency + phase;
    if (!(std::fabs(value) < kWrap)) value = std::fmod(value, kWrap);
  }
  if (value < 0.0) value -= std::floor(value);
  switch (form) {
    case Form::kRamp: return value;
    case Form::kTriangle: return triangle_wave(value);
    case Form::kSine: return (1.0 + cycloidal(value)) * 0.5;
    case Form::kScallop: return std::fabs(cycloidal(value * 0.5));
    case Form::kCubic: return value * value * (3.0 - 2.0 * value);
    case Form::kPoly: return std::pow(value, exponent);
  }
  return value;
}

}  // namespace lentray::core
