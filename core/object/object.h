// An object of a compiled scene: what rays can meet, with its looks, its clips and its gates. Shapes
// that stand in the world are core/object/leaf.h, CSG of objects is core/object/csg.h.
// Space: world. Constant to its users while rendering: a CSG of many parts builds their hierarchy at
// the first question. Scratch memory comes from the caller's HitArena.
// Source: reference manual 3.7, "Objects", "Object Modifiers".
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
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
  /// Everything that inside() can answer true for, unless it is gated; infinite for most inverse objects.
  virtual Bounds solid_bounds() const = 0;
  /// Whether solid_bounds() is a solid gate, of the object or of a part: inside() may be true beyond
  /// it. Says nothing of gates().
  virtual bool is_gated() const { return solid_gate() != nullptr; }
  /// Everything that inside() can answer false for; infinite for most objects but inverse ones.
  virtual Bounds void_bounds() const = 0;
  /// Nearest crossing with t_min < t < t_max; fills t, leaf and shape, not `object`. Leaves the hit
  /// as it was if there is none.
  virtual bool nearest(const Ray& ray, double t_min, double t_max, Hit& hit,
                       const RayQuery& query) const = 0;
  /// Appends all crossings, in any order.
  virtual void all(const Ray& ray, double t_min, double t_max, std::vector<Hit>& hits,
                   const RayQuery& query) const = 0;
  /// all() for shadow rays at an object that is no part of a CSG (ShapeTraits::tells_first_alone).
  virtual void all_alone(const Ray& ray, double t_min, double t_max, std::vector<Hit>& hits,
                         const RayQuery& query) const {
    all(ray, t_min, t_max, hits, query);
  }
  virtual bool any(const Ray& ray, double t_min, double t_max, const RayQuery& query) const {
    Hit hit;
    return nearest(ray, t_min, t_max, hit, query);
  }
  /// As SDL's inside(): clipping and `inverse` count.
  virtual bool inside(const Vec3& p) const = 0;
  /// Every primitive below, itself included (for what looks and types occur).
  virtual void leaves(std::vector<const Leaf*>& out) const = 0;

  /// A ray whose line misses it misses the object. It holds all of the surface but what stands out
  /// of the gates.
  const Ball& ball() const { return m_ball; }
  /// Holds all that inside() can answer true for and the surface, whatever the gates say;
  /// everything where one of them is infinite.
  virtual Ball solid_ball() const = 0;
  /// True where all of the surface lies in the solid of every part that is not inverse: a single
  /// shape, or an intersection of such.
  virtual bool lies_in_parts() const = 0;
  /// True of finite solids that no ray leaves without a crossing that all() tells of.
  virtual bool is_closed() const = 0;

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
    limits().clips = std::move(clips);
    fit_ball();
    clips_have_changed();
  }
  const Regions& clips() const { return m_limits ? m_limits->clips : kNoRegions; }
  /// Regions that rays must meet: one that misses a gate, and does not begin inside it, misses the object
  /// (`bounded_by` in SDL).
  void set_gates(Regions gates) {
    limits().gates = std::move(gates);
    fit_ball();
  }
  const Regions& gates() const { return m_limits ? m_limits->gates : kNoRegions; }
  /// A box that replaces solid_bounds(). Beyond it a CSG with this part and SolidIndex do not ask
  /// inside(). Inverting the object drops it, inverting again restores it.
  void set_solid_gate(const Bounds& box) {
    limits().solid_gate = box;
    limits().gate_is_of_inverse = m_inverse;
  }
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
  bool passes_gates(const Ray& ray, const RayQuery& query) const;
  /// Null: there is none, or one for the object's inverse.
  const Bounds* solid_gate() const {
    if (!m_limits || !m_limits->solid_gate || m_limits->gate_is_of_inverse != m_inverse)
      return nullptr;
    return &*m_limits->solid_gate;
  }
  /// `b` cut by the boxes of the clipping objects, and of the gates where it is infinite.
  Bounds limited(Bounds b) const;
  /// The ball before own clips and gates.
  virtual Ball surface_ball() const = 0;
  virtual void clips_have_changed() {}
  /// To be called when anything has changed that the ball depends on.
  void fit_ball();
  /// The first ball, before there are clips or gates.
  void set_ball(const Ball& ball) { m_ball = ball; }
  void set_convexity(Convexity convexity) { m_convexity = convexity; }
  const Ball& first_ball() const { return m_limits ? m_limits->first_ball : m_ball; }
  /// Of a leaf: whether the normal of its shape points the wrong way.
  bool turns_normal() const { return m_turns_normal; }
  void set_turns_normal(bool turns) { m_turns_normal = turns; }

 private:
  /// Apart: few objects have any, and there may be a million of these.
  struct Limits {
    Regions clips, gates;
    Ball first_ball;
    std::optional<Bounds> solid_gate;
    bool gate_is_of_inverse = false;
  };
  Limits& limits() {
    if (!m_limits) m_limits = std::make_unique<Limits>(Limits{{}, {}, m_ball, std::nullopt});
    return *m_limits;
  }
  static inline const Regions kNoRegions;

  Ball m_ball;
  Attributes m_attributes;
  std::unique_ptr<Limits> m_limits;
  bool m_turns_normal = false;
  bool m_inverse = false;
  bool m_opaque = false;
  Convexity m_convexity = Convexity::kNone;
  std::uint32_t m_whole = 0;
  double m_test_cost = 1.0;
};

/// Whether rays may meet an object beyond kFarthest: if a part of it is a box, cylinder or cone, or keeps
/// a transform of its own. For building; walks through all parts. Source: docs/language.md.
bool is_seen_afar(const Object& object);

}  // namespace lentray::core
