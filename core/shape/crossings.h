// What a shape makes of its crossings with a ray, nearest first: a convex one has a few at once,
// others find one after the other.
#pragma once

#include "core/shape/shape.h"

namespace lentray::core {

/// A crossing of a shape that has no places on its elements: smaller to carry about.
struct Crossing {
  double t;
  std::uint32_t element;
};

/// The elements of cones and cylinders.
inline constexpr std::uint32_t kSide = 0, kBase = 1, kCap = 2;
/// How far outside a point still counts as inside of an open one, and the reverse of a closed one, relative to
/// radius and length.
inline constexpr double kRoundTolerance = 1e-10;

/// The first of `count` crossings, sorted by t, with t_min < t < t_max.
inline bool first_between(const Crossing* found, int count, double t_min, double t_max,
                          ShapeHit& hit) {
  for (int i = 0; i < count; ++i) {
    if (!(found[i].t > t_min)) continue;
    if (!(found[i].t < t_max)) return false;
    hit = {found[i].t, found[i].element, 0.0, 0.0};
    return true;
  }
  return false;
}

/// Appends those with t_min < t < t_max.
inline void append_between(const Crossing* found, int count, double t_min, double t_max,
                           ShapeHits& hits) {
  for (int i = 0; i < count; ++i) {
    if (found[i].t > t_min && found[i].t < t_max)
      hits.push_back({found[i].t, found[i].element, 0.0, 0.0});
  }
}

/// The first crossing with t_min < t < t_max. `each` calls its argument with t in order, until that
/// returns false.
template <class Each>
bool first_of_ordered(Each&& each, double t_min, double t_max, ShapeHit& hit) {
  bool found = false;
  each([&](double t) {
    if (!(t > t_min)) return true;
    if (t < t_max) {
      hit = {t, 0, 0.0, 0.0};
      found = true;
    }
    return false;
  });
  return found;
}

/// Appends all of them.
template <class Each>
void append_ordered(Each&& each, double t_min, double t_max, ShapeHits& hits) {
  each([&](double t) {
    if (t > t_min && t < t_max) hits.push_back({t, 0, 0.0, 0.0});
    return t < t_max;
  });
}

/// The nearest crossing with t_min < t < t_max. `each` calls its argument with t, the element and
/// the place on it, in any order.
template <class Each>
bool nearest_of_all(Each&& each, double t_min, double t_max, ShapeHit& hit) {
  bool found = false;
  each([&](double t, std::uint32_t element, double place) {
    if (!(t > t_min && t < t_max)) return;
    hit = {t, element, place, 0.0};
    t_max = t;
    found = true;
  });
  return found;
}

/// Appends all of them.
template <class Each>
void append_all(Each&& each, double t_min, double t_max, ShapeHits& hits) {
  each([&](double t, std::uint32_t element, double place) {
    if (t > t_min && t < t_max) hits.push_back({t, element, place, 0.0});
  });
}

}  // namespace lentray::core
