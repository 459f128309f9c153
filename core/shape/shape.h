// A primitive's geometry alone: where a ray meets it, what is inside, which way it faces.
// Space: the shape's own (object space); `baked` moves it into another. Immutable; any number
// of threads may ask at once. Hits have t_min < t < t_max; t in multiples of ray.direction.
#pragma once

#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

#include "core/base/ball.h"
#include "core/base/bounds.h"
#include "core/base/ray.h"

namespace lentray::core {

/// One crossing of a ray with a shape, in the shape's space.
struct ShapeHit {
  double t = 0.0;
  std::uint32_t element = 0;  ///< which face of the shape (triangle of a mesh, side of a box ...)
  double u = 0.0, v = 0.0;    ///< where on that face, as the shape itself defines it
};
using ShapeHits = std::vector<ShapeHit>;

/// What is certain of a ray that leaves a surface on the side to which its normal points.
enum class Convexity : std::uint8_t {
  kNone,    ///< nothing
  kConvex,  ///< it does not meet the surface again: that lies behind the normal's plane
  kOpen,    ///< the same, but a ray that is in the solid may leave it without a crossing
  kFlat,    ///< the same as of kOpen, on either side
};

/// What holds for all points and rays alike.
struct ShapeTraits {
  std::string_view name;  ///< SDL keyword of the statement, for statistics and messages ("sphere")
  /// Of rays that leave the surface after a hit from outside, but for rounding. kNone for patches
  /// whose shading normal is not that of their plane.
  Convexity convexity = Convexity::kNone;
  bool is_solid = true;  ///< false for patches: they have no inside, and `inverse` changes nothing
  bool solid_is_unbounded =
      false;            ///< bounds() holds the surface alone, and inside() may be true beyond it
  bool has_uv = false;  ///< texture coordinates of its own
  bool finds_all_at_once = false;  ///< all() costs no more than nearest(), which works all out too
  bool is_seen_afar = false;       ///< beyond kFarthest (core/base/ray.h), too
  bool tells_all = true;           ///< false: all() may miss what a new ray from a crossing meets
};

class Shape {
 public:
  virtual ~Shape() = default;

  virtual ShapeTraits traits() const = 0;
  std::string_view name() const { return traits().name; }
  /// Everything of the surface; of the solid too unless the traits say otherwise. May be infinite.
  Bounds bounds() const { return box(nullptr); }
  /// The same after a transform.
  Bounds bounds_in(const Transform& t) const { return box(&t); }
  /// Both of them; null: as it stands.
  virtual Bounds box(const Transform* move) const = 0;
  /// Holds what bounds() holds; shapes override it where the ball of the box is not tight.
  virtual Ball ball() const { return Ball::around(bounds()); }

  /// Nearest crossing.
  virtual bool nearest(const Ray& ray, double t_min, double t_max, ShapeHit& hit) const = 0;
  /// Appends every crossing, in any order (CSG and clipping need them all).
  virtual void all(const Ray& ray, double t_min, double t_max, ShapeHits& hits) const = 0;
  /// Whether there is any crossing. The answer is the same as that of nearest().
  virtual bool any(const Ray& ray, double t_min, double t_max) const {
    ShapeHit hit;
    return nearest(ray, t_min, t_max, hit);
  }

  /// As `inside` in SDL of the shape, or of its `inverse`. A point on a surface may be in both or neither;
  /// shapes without a solid hold nothing.
  virtual bool holds(const Vec3& p, bool inverse) const {
    (void)p;
    (void)inverse;
    return false;
  }
  bool inside(const Vec3& p) const { return holds(p, false); }
  /// Shading normal, not necessarily unit; outwards for solids.
  virtual Vec3 normal(const Vec3& p, const ShapeHit& hit) const = 0;
  /// Texture coordinates for uv_mapping. Kinds without any of their own take x and y of the world point.
  virtual Vec2 uv(const Vec3& p, const ShapeHit& hit) const {
    (void)hit;
    return {p.x, p.y};
  }

  /// The same shape in the space `t` leads to, or null if this kind cannot hold it
  /// (then the object keeps the transform and moves the rays).
  virtual std::unique_ptr<Shape> baked(const Transform& t) const {
    (void)t;
    return nullptr;
  }
};

/// A box that is moved as a box; null: not at all.
inline Bounds moved_box(const Bounds& b, const Transform* move) {
  return move ? transformed(b, *move) : b;
}

}  // namespace lentray::core
