#include <cmath>

#include "core/noise/noise.h"
#include "core/pattern/pattern.h"

namespace lentray::core {

double Wave::shaped(double value) const {
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
