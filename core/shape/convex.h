// The convex solids among the simplest shapes as one closed set: where a line crosses one, and on which
// side of its surface a point surely lies. Space: the shape's. Immutable; any number of threads.
#pragma once

#include "core/base/bounds.h"
#include "core/base/ray.h"
#include "core/shape/crossings.h"
#include "core/shape/side.h"

namespace lentray::core {

/// A box, sphere, plane, or closed cone or cylinder.
class Convex {
 public:
  /// Whether the shape is one of them.
  static bool holds(const Shape& shape);
  /// The shape must stay alive. The margin, far above the rounding of the points that side() is asked for,
  /// is in the shape's space.
  Convex(const Shape& shape, double margin);

  /// What Shape::all() finds beyond t_min and perhaps some of the others, ascending: up to 2.
  int crossings(const Ray& ray, double t_min, Crossing* out) const;
  /// Shape::holds() agrees with it unless it is kNear, and so it does of all points half a margin around.
  Side side(const Vec3& p) const;
  /// Whether there is one crossing at most, and if so, whether the ray is inside before it.
  bool is_half_space() const { return m_kind == Kind::kPlane; }
  bool is_entered_along(const Vec3& direction) const;

 private:
  enum class Kind : std::uint8_t { kNone, kBox, kSphere, kPlane, kCone, kCylinder };
  static Kind kind_of(const Shape& shape);

  const Shape* m_shape;
  Kind m_kind;
  double m_margin;
  Bounds m_surely, m_perhaps;  ///< of a box: smaller and larger by the margin
};

}  // namespace lentray::core
