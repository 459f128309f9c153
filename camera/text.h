// Numbers in messages.
#pragma once

#include <cstdio>
#include <string>

#include "core/base/vec3.h"

namespace lentray::camera {

/// Up to six significant digits, as "%g" writes them.
inline std::string format(double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.6g", value);
  return buffer;
}

/// Up to four, for figures that nobody computes with.
inline std::string brief(double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.4g", value);
  return buffer;
}

/// "x,y,z" with every digit, so that it reads back as the same vector.
inline std::string text_of(const core::Vec3& v) {
  char buffer[96];
  std::snprintf(buffer, sizeof buffer, "%.17g,%.17g,%.17g", v.x, v.y, v.z);
  return buffer;
}

}  // namespace lentray::camera
