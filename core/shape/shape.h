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

class Shape {
 public:
  virtual ~Shape() = default;

  /// SDL keyword of the statement, for statistics and messages ("sphere").
  virtual std::string_view name() const = 0;
  /// Everything of the surface; of the solid too where that is finite. May be infinite.
  virtual Bounds bounds() const = 0;
  /// The same after a transform; shapes override it where the box of the box is not tight.
  virtual Bounds bounds_in(const Transform& t) const { return transformed(bounds(), t); }

  /// Holds what bounds() holds; shapes override it where the ball of the box is not tight.
  virtual Ball ball() const { return Ball::around(bounds()); }
  /// Appends points with the whole surface in their convex hull, but for rounding; none where it is
  /// infinite. Shapes override it where the corners of the box are far outside.
  virtual void hull(std::vector<Vec3>& points) const { add_corners(bounds(), points); }

  /// Nearest crossing.
  virtual bool nearest(const Ray& ray, double t_min, double t_max, ShapeHit& hit) const = 0;
  /// Appends every crossing, in any order (CSG and clipping need them all).
  virtual void all(const Ray& ray, double t_min, double t_max, ShapeHits& hits) const = 0;
  /// What a ray of light meets of the shape alone: for some that is less, as of nearest().
  virtual void all_alone(const Ray& ray, double t_min, double t_max, ShapeHits& hits) const {
    all(ray, t_min, t_max, hits);
  }
  /// Whether there is any crossing. The answer is the same as that of nearest().
  virtual bool any(const Ray& ray, double t_min, double t_max) const {
    ShapeHit hit;
    return nearest(ray, t_min, t_max, hit);
  }

  /// True where all() costs no more than nearest(), which works all out too.
  virtual bool finds_all_at_once() const { return false; }
  /// False where a ray that begins anew at one crossing may meet some that all() leaves out.
  virtual bool tells_all() const { return true; }
  /// As `inside` in SDL, before any `inverse`. Shapes without a solid answer false.
  virtual bool inside(const Vec3& p) const = 0;
  /// As `inside` of the inverse. Not always the opposite: a point on a surface may be in both or
  /// neither, and shapes without a solid answer false again.
  virtual bool outside(const Vec3& p) const { return !inside(p); }
  /// True where bounds() holds the surface alone and inside() is true beyond it.
  virtual bool solid_is_unbounded() const { return false; }
  /// The same, but stock takes a box for the solid's when it bounds a CSG, so that rays which miss the
  /// box miss the CSG.
  virtual bool solid_leaves_bounds() const { return false; }
  /// That box, after a transform.
  virtual Bounds csg_bounds_in(const Transform& t) const { return bounds_in(t); }
  /// False for patches, which `inverse` does not change.
  virtual bool is_solid() const { return true; }
  /// Whether the normal of the inverse points the other way, which decides what is behind.
  virtual bool inverse_turns_normal() const { return is_solid(); }
  /// But for rounding, and of hits from outside alone. Patches whose normal is not that of their plane have none.
  virtual Convexity convexity() const { return Convexity::kNone; }
  /// Shading normal, not necessarily unit, pointing as stock's does (outwards for solids).
  virtual Vec3 normal(const Vec3& p, const ShapeHit& hit) const = 0;
  /// Texture coordinates for uv_mapping. Kinds without any of their own (has_uv) take x and y of
  /// the world point, as stock does.
  virtual bool has_uv() const { return false; }
  virtual Vec2 uv(const Vec3& p, const ShapeHit& hit) const { (void)hit; return {p.x, p.y}; }

  /// The same shape in the space `t` leads to, or null if this kind cannot hold it
  /// (then the object keeps the transform and moves the rays).
  virtual std::unique_ptr<Shape> baked(const Transform& t) const { (void)t; return nullptr; }
  /// Before the shape is asked: crossings beyond the ball are not wanted, and may be left out. For
  /// shapes that search the whole ray otherwise.
  virtual void keep_within(const Ball& ball) { (void)ball; }
  /// For tests, before the shape is shared or asked: infinite boxes and plain lists instead of those
  /// that only spare work. Answers keep their bits; bounds() may become infinite.
  virtual void drop_shortcuts() {}
  /// Bytes held, for the memory statistics.
  virtual std::size_t memory() const { return sizeof(*this); }
};

}  // namespace lentray::core
