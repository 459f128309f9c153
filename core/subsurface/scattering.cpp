#include "core/subsurface/scattering.h"

#include <algorithm>
#include <cmath>

namespace lentray::core {

double diffuse_fresnel_reflectance(double relative_ior) {
  if (relative_ior < 1.0) return relative_ior * relative_ior - std::pow(relative_ior, 2.25);
  const double x = 1.0 - 1.0 / relative_ior;
  return (x + 3.0 * std::pow(x, 4.5)) / 4.0;
}

double boundary_factor(double relative_ior) {
  const double inside = diffuse_fresnel_reflectance(relative_ior);
  return (1.0 + inside) / (1.0 - inside);
}

double diffuse_reflectance(double boundary_factor, double reduced_albedo) {
  const double root = std::sqrt(3.0 * (1.0 - reduced_albedo));
  return reduced_albedo / 2.0 * (1.0 + std::exp(-4.0 / 3.0 * boundary_factor * root)) *
         std::exp(-root);
}

ReducedAlbedo::ReducedAlbedo(double ior) : m_ior(ior) {
  constexpr int kHalvings = 50;
  const double factor = boundary_factor(ior);
  for (int step = 1; step < kSteps; ++step) {
    double low = 0.0, high = 1.0;
    for (int i = 0; i < kHalvings; ++i) {
      const double middle = (low + high) / 2.0;
      const bool too_little =
          diffuse_reflectance(factor, middle) < static_cast<double>(step) / kSteps;
      (too_little ? low : high) = middle;
    }
    m_albedo[static_cast<std::size_t>(step)] = (low + high) / 2.0;
  }
  m_albedo.front() = 0.0;
  m_albedo.back() = 1.0;
}

double ReducedAlbedo::at(double reflectance) const {
  const double place = std::clamp(reflectance, 0.0, 1.0) * kSteps;
  const auto below = static_cast<std::size_t>(place);
  if (below >= kSteps) return m_albedo.back();
  const double part = place - static_cast<double>(below);
  return (1.0 - part) * m_albedo[below] + part * m_albedo[below + 1];
}

Scattering scattering_of(const ReducedAlbedo& albedo, const Rgb& colour, const Rgb& translucency) {
  constexpr std::array<double, 3> kGrey{0.297, 0.589, 0.114};
  Scattering result{};
  double weights = 0.0;
  for (std::size_t c = 0; c < 3; ++c) {
    const int channel = static_cast<int>(c);
    const double left = albedo.at(colour[channel]);
    if (!(left > 0.0)) continue;
    result.scattered[c] = 1.0 / translucency[channel];
    result.lost[c] = result.scattered[c] / left;
    result.mean_lost += kGrey[c] * result.lost[c];
    weights += kGrey[c];
  }
  if (weights > 0.0) result.mean_lost /= weights;
  return result;
}

}  // namespace lentray::core
