// Numbers in messages.
#pragma once

#include <cstdio>
#include <string>

namespace lentray::camera {

/// Up to six significant digits, as "%g" writes them.
inline std::string format(double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.6g", value);
  return buffer;
}

}  // namespace lentray::camera
