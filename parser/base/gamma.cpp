#include "parser/base/gamma.h"

#include <algorithm>
#include <cmath>

#include "core/image/srgb.h"

namespace lentray::parser {

namespace {

/// Colours may be negative; no power is.
float powered(float value, double exponent) {
  return exponent == 1.0 ? value : std::pow(std::max(value, 0.0f), static_cast<float>(exponent));
}

}  // namespace

float Gamma::recoded(float value, const Gamma& to) const {
  if (is_alike(to)) return value;
  if (to.is_srgb()) return core::srgb_of_linear(powered(value, m_power));
  if (is_srgb()) return powered(core::linear_of_srgb(value), 1.0 / to.m_power);
  return powered(value, m_power / to.m_power);
}

bool Gamma::is_alike(const Gamma& other) const {
  constexpr double kAlike = 0.01;
  if (is_srgb() || other.is_srgb()) return is_srgb() && other.is_srgb();
  return std::fabs(m_power / other.m_power - 1.0) < kAlike;
}

}  // namespace lentray::parser
