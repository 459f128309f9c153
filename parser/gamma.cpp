#include "parser/gamma.h"

#include <algorithm>
#include <cmath>

namespace lentray::parser {

namespace {

float linear_of_srgb(float v) { return v <= 0.04045f ? v / 12.92f : std::pow((v + 0.055f) / 1.055f, 2.4f); }
float srgb_of_linear(float v) { return v <= 0.0031308f ? v * 12.92f : 1.055f * std::pow(v, 1.0f / 2.4f) - 0.055f; }

/// Colours may be negative; no power is.
float powered(float value, double exponent) {
  return exponent == 1.0 ? value : std::pow(std::max(value, 0.0f), static_cast<float>(exponent));
}

}  // namespace

float Gamma::recoded(float value, const Gamma& to) const {
  if (is_alike(to)) return value;
  if (to.is_srgb()) return srgb_of_linear(powered(value, m_power));
  if (is_srgb()) return powered(linear_of_srgb(value), 1.0 / to.m_power);
  return powered(value, m_power / to.m_power);
}

bool Gamma::is_alike(const Gamma& other) const {
  constexpr double kAlike = 0.01;
  if (is_srgb() || other.is_srgb()) return is_srgb() && other.is_srgb();
  return std::fabs(m_power / other.m_power - 1.0) < kAlike;
}

}  // namespace lentray::parser
