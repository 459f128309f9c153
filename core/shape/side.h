// On which side of a solid's surface a point lies, with a margin. Any space.
#pragma once

#include <cstdint>

namespace lentray::core {

/// kNear: closer to the surface than the margin, so that roundings may decide.
enum class Side : std::uint8_t { kInside, kOutside, kNear };

/// By a value that is negative inside.
inline Side side_by(double value, double tolerance) {
  return value < -tolerance ? Side::kInside : value > tolerance ? Side::kOutside : Side::kNear;
}

}  // namespace lentray::core
