#include "core/material/phase_function.h"

#include <cmath>

namespace lentray::core {
namespace {

// Source: POV-Ray 3.7 (tests/unit/material/phase_function_test.cpp).
constexpr double kRayleigh = 0.799372013;
constexpr double kHazy = 0.576655375;
constexpr double kMurky = 0.495714547;

double mie(double scale, double peak, double power, double cosine) {
  return scale * (1.0 + peak * std::pow(0.5 * (1.0 + cosine), power));
}

}  // namespace

double PhaseFunction::operator()(double cosine) const {
  switch (kind) {
    case Kind::kMieHazy: return mie(kHazy, 9.0, 8.0, cosine);
    case Kind::kMieMurky: return mie(kMurky, 50.0, 32.0, cosine);
    case Kind::kRayleigh: return kRayleigh * (1.0 + cosine * cosine);
    case Kind::kHenyeyGreenstein: {
      const double g = eccentricity;
      return (1.0 - g * g) / std::pow(1.0 + g * g - 2.0 * g * cosine, 1.5);
    }
    case Kind::kIsotropic: break;
  }
  return 1.0;
}

}  // namespace lentray::core
