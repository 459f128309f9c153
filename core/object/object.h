// An object of a compiled scene: what rays can meet, with its material and its clips. Shapes that stand in
// the world are core/object/leaf.h, CSG of objects is core/object/csg.h, what is seen through bounds alone
// is core/object/gated.h.
// Space: world. Immutable while rendering. Scratch memory comes from the caller's HitLists.
// Source: reference manual 3.7, "Objects", "Object Modifiers".
#pragma once

#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

#include "core/base/ball.h"
#include "core/base/bounds.h"
#include "core/base/ray.h"
#include "core/object/attributes.h"
#include "core/object/hit.h"
#include "core/shape/shape.h"

namespace lentray::core {

class Object {
 public:
  using Regions = std::vector<std::shared_ptr<const Object>>;

  virtual ~Object() = default;
  virtual std::string_view name() const = 0;
  /// Everything of the surface that rays can meet, clipping counted. May be infinite.
  virtual Bounds bounds() const = 0;
  /// Everything that inside() can answer true for; infinite for most inverse objects.
  virtual Bounds solid_bounds() const = 0;
  /// Everything that inside() can answer false for; infinite for most objects but inverse ones.
  virtual Bounds void_bounds() const = 0;
  /// Nearest crossing with t_min < t < t_max; fills t, leaf and shape, not `object`. Leaves the hit
  /// as it was if there is none.
  virtual bool nearest(const Ray& ray, double t_min, double t_max, Hit& hit,
                       const RayQuery& query) const = 0;
  /// Appends all crossings, in any order.
  virtual void all(const Ray& ray, double t_min, double t_max, std::vector<Hit>& hits,
                   const RayQuery& query) const = 0;
  virtual bool any(const Ray& ray, double t_min, double t_max, const RayQuery& query) const {
    Hit hit;
    return nearest(ray, t_min, t_max, hit, query);
  }
  /// As SDL's inside(): clipping and `inverse` count.
  virtual bool inside(const Vec3& p) const = 0;
  /// Every primitive below, itself included (for what materials and types occur).
  virtual void leaves(std::vector<const Leaf*>& out) const = 0;

  /// A ray whose line misses it misses the object.
  const Ball& ball() const { return m_ball; }
  /// Holds all that inside() can answer true for and the surface; everything where one of them is infinite.
  virtual Ball solid_ball() const = 0;
  /// True where all of the surface lies in the solid of every part that is not inverse: a single
  /// shape, or an intersection of such.
  bool lies_in_parts() const { return m_lies_in_parts; }
  /// True of finite solids that no ray leaves without a crossing that all() finds.
  bool is_closed() const {
    return (m_closed || convexity() == Convexity::kConvex) && clips().empty();
  }

  const Attributes& attributes() const { return m_attributes; }
  void set_attributes(const Attributes& a) { m_attributes = a; }
  /// As `inverse` in SDL. Shapes without a solid stay as they are; CSG turns into its complement
  /// (union to intersection, intersection to merge, of inverse parts).
  virtual void set_inverse(bool inverse) { m_inverse = inverse; }
  bool is_inverse() const { return m_inverse; }
  /// Of a leaf: that of its shape; none of inverse ones and of CSG.
  Convexity convexity() const { return m_inverse ? Convexity::kNone : m_convexity; }
  /// Surfaces are kept where they are inside every clipping object.
  void set_clips(Regions clips) {
    if (!m_limits) m_limits = std::make_unique<Limits>(Limits{{}, m_ball});
    m_limits->clips = std::move(clips);
    m_ball = within_clips(m_limits->unclipped_ball);
  }
  const Regions& clips() const { return m_limits ? m_limits->clips : kNoRegions; }
  /// True when every leaf's textures are fully opaque (set by the scene compiler).
  bool is_opaque() const { return m_opaque; }
  void set_opaque(bool opaque) { m_opaque = opaque; }
  /// Which object of the source it comes from: parts of a union that is split share the number (set by the scene).
  std::uint32_t whole() const { return m_whole; }
  void set_whole(std::uint32_t number) { m_whole = number; }
  /// core/accel/test_cost.h (set by the scene compiler).
  double test_cost() const { return m_test_cost; }
  void set_test_cost(double cost) { m_test_cost = cost; }

 protected:
  bool passes_clips(const Vec3& p) const;
  /// `b` cut by the boxes of the clipping objects.
  Bounds within_clips(Bounds b) const;
  /// The smallest of `ball` and those of the clipping objects' solids.
  Ball within_clips(Ball ball) const;
  /// Of all of the surface, before own clips.
  void set_ball(const Ball& ball) {
    if (m_limits) m_limits->unclipped_ball = ball;
    m_ball = within_clips(ball);
  }
  const Ball& unclipped_ball() const { return m_limits ? m_limits->unclipped_ball : m_ball; }
  void set_convexity(Convexity convexity) { m_convexity = convexity; }
  /// Of CSG: before own clips.
  void set_closed(bool closed) { m_closed = closed; }
  void set_lies_in_parts(bool lies) { m_lies_in_parts = lies; }

 private:
  /// Apart: few objects have any, and there may be a million of these.
  struct Limits {
    Regions clips;
    Ball unclipped_ball;
  };
  static inline const Regions kNoRegions;

  Ball m_ball;
  Attributes m_attributes;
  std::unique_ptr<Limits> m_limits;
  bool m_inverse : 1 = false;
  bool m_opaque : 1 = false;
  bool m_lies_in_parts : 1 = true;
  bool m_closed : 1 = false;
  Convexity m_convexity = Convexity::kNone;
  std::uint32_t m_whole = 0;
  double m_test_cost = 1.0;
};

/// Whether rays may meet an object beyond kFarthest: where a shape of it is seen there, or keeps a transform
/// of its own. For building; walks through all parts. Source: docs/language.md.
bool is_seen_afar(const Object& object);

/// Once all else of the object and its parts is set, before any question of a ray or a point: each CSG of many
/// parts builds the hierarchies over them.
void complete(Object& object);

/// Appends all crossings with the object, or the `nearest` alone.
inline void add_hits(const Object& object, const Ray& ray, double t_min, double t_max, bool nearest,
                     std::vector<Hit>& hits, const RayQuery& query) {
  if (!nearest) return object.all(ray, t_min, t_max, hits, query);
  Hit hit;
  if (object.nearest(ray, t_min, t_max, hit, query)) hits.push_back(hit);
}

}  // namespace lentray::core
