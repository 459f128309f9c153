// A ray made ready for tests against boxes. Any space.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/base/bounds.h"
#include "core/base/ray.h"

namespace lentray::core {

/// A ray for box tests that allow for the rounding of their numbers.
struct BoxRay {
  explicit BoxRay(const Ray& ray)
      : origin(ray.origin), inverse{1.0 / ray.direction.x, 1.0 / ray.direction.y,
                                    1.0 / ray.direction.z} {}

  bool meets(const Bounds& b, double t_min, double t_max) const { return cut(b, t_min, t_max); }
  /// Cuts from..to to what is in the box; false if that is nothing.
  bool cut(const Bounds& b, double& from, double& to) const {
    constexpr double kSlack = 2e-15;
    for (int i = 0; i < 3; ++i) {
      const bool forward = inverse[i] > 0.0;
      const double near = ((forward ? b.lo[i] : b.hi[i]) - origin[i]) * inverse[i];
      const double far = ((forward ? b.hi[i] : b.lo[i]) - origin[i]) * inverse[i];
      from = near > from ? near : from;  // not a number (along a side): the axis does not cut
      to = far < to ? far : to;
    }
    return from - std::fabs(from) * kSlack <= to + std::fabs(to) * kSlack;
  }

  Vec3 origin, inverse;
};

/// Where the ray enters the box: 0 inside, and for infinite ones.
inline double entry_distance(const Bounds& box, const Ray& ray) {
  if (!box.is_finite()) return 0.0;
  double entry = 0.0;
  for (int a = 0; a < 3; ++a) {
    const double d = ray.direction[a];
    if (d == 0.0) continue;
    entry = std::max(entry, ((d > 0.0 ? box.lo[a] : box.hi[a]) - ray.origin[a]) / d);
  }
  return entry;
}

}  // namespace lentray::core
