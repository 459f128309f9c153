#include "core/irradiance/settings.h"

#include <algorithm>
#include <cmath>

namespace lentray::core {

DepthRules rules_at(const RadiositySettings& settings, int depth) {
  constexpr double kLeastRays = 5.0, kLevelsABounce = 1.5;
  constexpr double kAboveBailout = 1e-10;  ///< so that no gather is cut before it begins
  const double halved = std::ldexp(settings.count, -depth);
  DepthRules rules;
  rules.rays = static_cast<unsigned>(std::max(kLeastRays, halved));
  rules.wanted = depth == 0   ? settings.nearest_count
                 : depth == 1 ? std::min(2, settings.nearest_count)
                              : 1.0;
  rules.error_factor = std::ldexp(1.0, depth);
  rules.gather_weight = std::max(settings.adc_bailout + kAboveBailout,
                                 std::pow(0.5 * settings.brightness, depth + 1));
  rules.gather_level = static_cast<int>(kLevelsABounce * (depth + 1));
  return rules;
}

}  // namespace lentray::core
