#include "tools/common/duration.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace lentray::tool {

std::string duration_text(double seconds) {
  char text[64];
  if (seconds < 9.95) {
    std::snprintf(text, sizeof text, "%.1f s", std::max(0.0, seconds));
  } else if (seconds < 99.5) {
    std::snprintf(text, sizeof text, "%.0f s", seconds);
  } else if (seconds < 3570.0) {
    const long long tens = std::llround(seconds / 10.0);
    std::snprintf(text, sizeof text, "%lld min %lld s", tens / 6, tens % 6 * 10);
  } else {
    const long long minutes = std::llround(seconds / 60.0);
    std::snprintf(text, sizeof text, "%lld h %lld min", minutes / 60, minutes % 60);
  }
  return text;
}

}  // namespace lentray::tool
