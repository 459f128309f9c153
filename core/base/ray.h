// A ray: points origin + t * direction. World space unless said otherwise.
// The direction need not be unit; t is in multiples of it.
#pragma once

#include "core/base/vec3.h"

namespace lentray::core {

/// How far along a ray of unit direction most surfaces are seen. Source: measured on stock.
inline constexpr double kFarthest = 1e7;

struct Ray {
  Vec3 origin;
  Vec3 direction;
  Vec3 at(double t) const { return origin + direction * t; }
};

}  // namespace lentray::core
