// Numbers in messages.
#pragma once

#include <string>

#include "core/base/formed.h"
#include "core/base/vec3.h"

namespace lentray::camera {

/// Up to six significant digits, as "%g" writes them.
inline std::string format(double value) { return core::formed("%.6g", value); }

/// Up to four, for figures that nobody computes with.
inline std::string brief(double value) { return core::formed("%.4g", value); }

/// "x,y,z" with every digit, so that it reads back as the same vector.
inline std::string text_of(const core::Vec3& v) {
  return core::formed("%.17g,%.17g,%.17g", v.x, v.y, v.z);
}

}  // namespace lentray::camera
