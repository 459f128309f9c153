// How much light the surface of a dielectric mirrors. Pure.
// Source: Fresnel's equations for unpolarised light; held against stock by
// tests/image/shading_finish_test.cpp.
#pragma once

#include <algorithm>
#include <cmath>

namespace lentray::core {

/// `cosine` of the angle of incidence, 0..1. `relative_ior`: beyond the surface over before it. 1 beyond the
/// critical angle.
inline double fresnel(double cosine, double relative_ior) {
  const auto square = [](double x) { return x * x; };
  const double under_root = square(relative_ior) + square(cosine) - 1.0;
  if (!(under_root > 0.0)) return 1.0;
  const double g = std::sqrt(under_root);
  const double sum = g + cosine, difference = g - cosine;
  const double across = 0.5 * (square(difference) / square(sum));
  const double f = across * (1.0 + square(cosine * sum - 1.0) / square(cosine * difference + 1.0));
  return std::min(1.0, std::max(0.0, f));
}

}  // namespace lentray::core
