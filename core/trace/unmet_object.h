// Which object the rays to the lights in front of a surface need not ask. World space. Pure.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/object/leaf.h"

namespace lentray::core {

/// A convex object that no ray meets which leaves its surface on the front side and rises by more than `slope`, its
/// cosine to the normal: from less a point that rounding put inside could still meet it. Null: none.
struct UnmetObject {
  const Object* object = nullptr;
  double slope = 0.0;
};

/// Of a hit at `point`. `tolerance`: of shadows. Objects whose test costs no more than to look for them here have none.
inline UnmetObject unmet_object(const Hit& hit, bool from_behind, const Vec3& point,
                                double tolerance) {
  // In test_cost()'s unit (core/accel/test_cost.h).
  constexpr double kWorthwhile = 12.0, kLeast = 1e-3, kRounding = 1e-9;
  if (!(hit.object->test_cost() >= kWorthwhile) || hit.leaf->convexity() == Convexity::kNone)
    return {};
  if (!hit.object->lies_in_parts()) return {};
  const bool either_side = hit.leaf->convexity() == Convexity::kFlat && hit.object == hit.leaf;
  if (from_behind && !either_side) return {};
  const double off =
      kRounding * (std::fabs(point.x) + std::fabs(point.y) + std::fabs(point.z) + hit.t);
  return {hit.object, std::max(kLeast, off / tolerance)};
}

}  // namespace lentray::core
