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

/// Of a shape without elements a crossing is its t alone.
inline ShapeHit hit_at(double t) { return {t, 0, 0.0, 0.0}; }
inline ShapeHit hit_at(const Crossing& found) { return {found.t, found.element, 0.0, 0.0}; }

/// A shape that a ray meets a few times at most, all found at once: up to kMost numbers or
/// Crossings. Self::crossings(ray, t_min, t_max, first_alone, found) gives them in ascending order and returns
/// how many; it may leave out what is not within the range, and the others if the first is asked for alone.
template <class Self, class Found, int kMost, class Base = Shape>
class FewCrossings : public Base {
 public:
  using Base::Base;

  bool nearest(const Ray& ray, double t_min, double t_max, ShapeHit& hit) const final {
    Found found[kMost];
    const int count = self().crossings(ray, t_min, t_max, true, found);
    for (int i = 0; i < count; ++i) {
      const ShapeHit next = hit_at(found[i]);
      if (!(next.t > t_min)) continue;
      if (!(next.t < t_max)) return false;
      hit = next;
      return true;
    }
    return false;
  }
  void all(const Ray& ray, double t_min, double t_max, ShapeHits& hits) const final {
    Found found[kMost];
    const int count = self().crossings(ray, t_min, t_max, false, found);
    for (int i = 0; i < count; ++i) {
      const ShapeHit next = hit_at(found[i]);
      if (next.t > t_min && next.t < t_max) hits.push_back(next);
    }
  }

 private:
  const Self& self() const { return static_cast<const Self&>(*this); }
};

/// A shape that a ray meets once at most.
template <class Self>
class OneCrossing : public Shape {
 public:
  void all(const Ray& ray, double t_min, double t_max, ShapeHits& hits) const final {
    ShapeHit hit;
    if (static_cast<const Self&>(*this).Self::nearest(ray, t_min, t_max, hit)) hits.push_back(hit);
  }
};

/// The first crossing with t_min < t < t_max. Self::crossings() calls its last argument with t
/// in order, until that returns false.
template <class Self>
bool first_of_ordered(const Self& shape, const Ray& ray, double t_min, double t_max,
                      ShapeHit& hit) {
  bool found = false;
  shape.crossings(ray, t_min, t_max, [&](double t) {
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
template <class Self>
void append_ordered(const Self& shape, const Ray& ray, double t_min, double t_max,
                    ShapeHits& hits) {
  shape.crossings(ray, t_min, t_max, [&](double t) {
    if (t > t_min && t < t_max) hits.push_back({t, 0, 0.0, 0.0});
    return t < t_max;
  });
}

/// The nearest crossing with t_min < t < t_max. Self::crossings() calls its last argument with t,
/// the element and the place on it, in any order.
template <class Self>
bool nearest_of_all(const Self& shape, const Ray& ray, double t_min, double t_max, ShapeHit& hit) {
  bool found = false;
  shape.crossings(ray, t_min, t_max, [&](double t, std::uint32_t element, double place) {
    if (!(t > t_min && t < t_max)) return;
    hit = {t, element, place, 0.0};
    t_max = t;
    found = true;
  });
  return found;
}

/// Appends all of them.
template <class Self>
void append_all(const Self& shape, const Ray& ray, double t_min, double t_max, ShapeHits& hits) {
  shape.crossings(ray, t_min, t_max, [&](double t, std::uint32_t element, double place) {
    if (t > t_min && t < t_max) hits.push_back({t, element, place, 0.0});
  });
}

}  // namespace lentray::core
