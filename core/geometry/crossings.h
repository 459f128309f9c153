// What a convex shape makes of its crossings with a ray: at most a few, nearest first.
#pragma once

#include "core/geometry/shape.h"

namespace lentray::core {

/// The first of `count` crossings, sorted by t, with t_min < t < t_max.
inline bool first_between(const ShapeHit* found, int count, double t_min, double t_max,
                          ShapeHit& hit) {
  for (int i = 0; i < count; ++i) {
    if (!(found[i].t > t_min)) continue;
    if (!(found[i].t < t_max)) return false;
    hit = found[i];
    return true;
  }
  return false;
}

/// Appends those with t_min < t < t_max.
inline void append_between(const ShapeHit* found, int count, double t_min, double t_max,
                           ShapeHits& hits) {
  for (int i = 0; i < count; ++i) {
    if (found[i].t > t_min && found[i].t < t_max) hits.push_back(found[i]);
  }
}

}  // namespace lentray::core
