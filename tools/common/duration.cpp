#include "tools/common/duration.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <utility>

#include "core/base/formed.h"

namespace lentray::tool {

std::string duration_text(double seconds) {
  if (seconds < 9.95) return core::formed("%.1f s", std::max(0.0, seconds));
  if (seconds < 99.5) return core::formed("%.0f s", seconds);
  if (seconds < 3570.0) {
    const long long tens = std::llround(seconds / 10.0);
    return core::formed("%lld min %lld s", tens / 6, tens % 6 * 10);
  }
  const long long minutes = std::llround(seconds / 60.0);
  return core::formed("%lld h %lld min", minutes / 60, minutes % 60);
}

std::string utc_text(const char* form) {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  gmtime_r(&now, &parts);
  char text[64];
  return {text, std::strftime(text, sizeof text, form, &parts)};
}

std::optional<double> duration_of(std::string_view text) {
  constexpr std::pair<std::string_view, double> kUnits[] = {
      {"", 1.0}, {"s", 1.0}, {"ms", 0.001}, {"min", 60.0}, {"m", 60.0}, {"h", 3600.0}};
  const std::string word(text);
  char* end = nullptr;
  const double value = std::strtod(word.c_str(), &end);
  if (end == word.c_str() || !(value > 0.0) || !std::isfinite(value)) return std::nullopt;
  const std::string_view unit(end);
  for (const auto& [name, seconds] : kUnits) {
    if (unit == name) return value * seconds;
  }
  return std::nullopt;
}

}  // namespace lentray::tool
