// Objects of a compiled scene: shapes placed in the world with their looks, and CSG of them.
// Space: world. Immutable while rendering; scratch memory comes from the caller's HitArena.
// Source: reference manual 3.7, "Objects", "Object Modifiers", "Constructive Solid Geometry".
#pragma once

#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

#include "core/base/bounds.h"
#include "core/base/ray.h"
#include "core/geometry/shape.h"

namespace lentray::core {

class Texture;
struct Interior;
struct LightSelection;
class Leaf;
class Object;

/// Which objects a ray passes by unseen.
enum class RayKind : std::uint8_t {
  kCamera,       ///< not yet through anything; skips no_image
  kTransmitted,  ///< gone on through surfaces alone; skips no_image
  kReflection,   ///< reflected once or more; skips no_reflection
  kShadow,       ///< skips no_shadow
};

/// Looks and switches of an object, after inheritance through CSG is resolved.
struct Attributes {
  const Texture* texture = nullptr;           ///< owned by the scene; never null after compiling
  const Texture* interior_texture = nullptr;  ///< null: the same as `texture`
  const Interior* interior = nullptr;         ///< null: none was given
  const LightSelection* lights = nullptr;     ///< null: the global ones; owned by the scene
  bool no_shadow = false, no_image = false, no_reflection = false;
  bool hollow = false, double_illuminate = false;
  bool uv_mapping = false;                    ///< textures lie in texture coordinates
};

/// A crossing of a ray with an object.
struct Hit {
  double t = Bounds::kInf;
  const Leaf* leaf = nullptr;     ///< whose surface it is: gives normal and looks
  const Object* object = nullptr; ///< the object of the scene's list that it belongs to
  ShapeHit shape;                 ///< in the leaf's space
  std::uint32_t place = 0;        ///< where all hits are asked for: infinite objects, then the
                                  ///< others, in the order of the scene
};

/// Scratch lists of hits for nested CSG; one a thread; lists are reused, never shrunk.
class HitArena {
 public:
  std::vector<Hit>& acquire();
  void release() { --m_used; }
  ShapeHits shape_hits;
  RayKind ray_kind = RayKind::kShadow;  ///< of the ray under way: CSG has parts that some do not see

 private:
  std::vector<std::unique_ptr<std::vector<Hit>>> m_lists;
  std::size_t m_used = 0;
};

class Object {
 public:
  using Regions = std::vector<std::shared_ptr<const Object>>;

  virtual ~Object() = default;
  virtual std::string_view name() const = 0;
  /// Everything of the surface that rays can meet, clipping counted. May be infinite.
  virtual Bounds bounds() const = 0;
  /// Everything that inside() can answer true for; infinite for most inverse objects.
  virtual Bounds solid_bounds() const = 0;
  /// True where inside() may be true beyond solid_bounds() all the same (discs, which count as
  /// half-spaces yet bound a CSG by their surface's box, as in stock).
  virtual bool solid_leaves_bounds() const = 0;
  /// Everything that inside() can answer false for; infinite for most objects but inverse ones.
  virtual Bounds void_bounds() const = 0;
  /// Nearest crossing with t_min < t < t_max; fills t, leaf and shape, not `object`. Leaves the hit
  /// as it was if there is none.
  virtual bool nearest(const Ray& ray, double t_min, double t_max, Hit& hit, HitArena& arena) const = 0;
  /// Appends all crossings, in any order.
  virtual void all(const Ray& ray, double t_min, double t_max, std::vector<Hit>& hits, HitArena& arena) const = 0;
  /// The same of an object that is no part of another (Shape::all_alone).
  virtual void all_alone(const Ray& ray, double t_min, double t_max, std::vector<Hit>& hits, HitArena& arena) const {
    all(ray, t_min, t_max, hits, arena);
  }
  virtual bool any(const Ray& ray, double t_min, double t_max, HitArena& arena) const {
    Hit hit;
    return nearest(ray, t_min, t_max, hit, arena);
  }
  /// As SDL's inside(): clipping and `inverse` count.
  virtual bool inside(const Vec3& p) const = 0;
  /// Every primitive below, itself included (for what looks and types occur).
  virtual void leaves(std::vector<const Leaf*>& out) const = 0;
  /// Shape::drop_shortcuts() of all shapes below, and the same of CSG. Bounds stay as they are.
  virtual void drop_shortcuts() = 0;

  /// A ray whose line misses it misses the object. It holds all of the surface but what stands out
  /// of bounded_by.
  const Ball& ball() const { return m_ball; }
  /// Holds all that inside() can answer true for and the surface, whatever bounded_by says;
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
  /// (union to intersection, intersection to merge, of inverse parts), as stock does it.
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
  /// bounded_by: rays that miss one of these, starting outside it, miss the object.
  void set_bounding(Regions b) {
    limits().bounding = std::move(b);
    fit_ball();
  }
  const Regions& bounding() const { return m_limits ? m_limits->bounding : kNoRegions; }
  /// Where a camera may be inside it: beyond its box stock does not ask.
  Bounds start_bounds() const { return m_limits ? m_limits->start : Bounds::everything(); }
  void set_start_bounds(const Bounds& box) { limits().start = box; }
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
  bool passes_bounding(const Ray& ray, HitArena& arena) const;
  /// `b` cut by the boxes of the clipping objects, and of bounded_by where it is infinite.
  Bounds limited(Bounds b) const;
  /// The ball before own clips and bounded_by.
  virtual Ball surface_ball() const = 0;
  virtual void clips_have_changed() {}
  /// To be called when anything has changed that the ball depends on.
  void fit_ball();
  void drop_ball() { m_ball = Ball(); }
  /// The first ball, before there are clips or bounded_by.
  void set_ball(const Ball& ball) { m_ball = ball; }
  void set_convexity(Convexity convexity) { m_convexity = convexity; }
  const Ball& first_ball() const { return m_limits ? m_limits->first_ball : m_ball; }

 private:
  /// Apart: few objects have any, and there may be a million of these.
  struct Limits {
    Regions clips, bounding;
    Ball first_ball;
    Bounds start = Bounds::everything();
  };
  Limits& limits() {
    if (!m_limits) m_limits = std::make_unique<Limits>(Limits{{}, {}, m_ball, Bounds::everything()});
    return *m_limits;
  }
  static inline const Regions kNoRegions;

  Ball m_ball;
  Attributes m_attributes;
  std::unique_ptr<Limits> m_limits;
  bool m_inverse = false;
  bool m_opaque = false;
  Convexity m_convexity = Convexity::kNone;
  std::uint32_t m_whole = 0;
  double m_test_cost = 1.0;
};

/// Whether rays may meet an object beyond kFarthest: if a part of it is a box, cylinder or cone, or keeps
/// a transform of its own. For building; walks through all parts. Where this is not what stock does:
/// docs/language.md.
bool is_seen_afar(const Object& object);

/// A shape in the world.
class Leaf final : public Object {
 public:
  /// The shape is baked into world space where it can be; otherwise the transform is kept.
  Leaf(std::unique_ptr<Shape> shape, const Transform& to_world);
  std::string_view name() const override { return m_shape->name(); }
  Bounds bounds() const override;
  Bounds solid_bounds() const override;
  bool solid_leaves_bounds() const override;
  Bounds void_bounds() const override;
  Ball solid_ball() const override;
  bool lies_in_parts() const override { return true; }
  bool is_closed() const override {
    return convexity() == Convexity::kConvex && clips().empty() && bounding().empty();
  }
  bool nearest(const Ray&, double t_min, double t_max, Hit&, HitArena&) const override;
  void all(const Ray&, double t_min, double t_max, std::vector<Hit>&, HitArena&) const override;
  void all_alone(const Ray&, double t_min, double t_max, std::vector<Hit>&, HitArena&) const override;
  bool any(const Ray&, double t_min, double t_max, HitArena&) const override;
  bool inside(const Vec3& p) const override;
  void leaves(std::vector<const Leaf*>& out) const override { out.push_back(this); }
  void drop_shortcuts() override {
    m_shape->drop_shortcuts();
    drop_ball();
  }

  const Shape& shape() const { return *m_shape; }
  const Transform* transform() const { return m_transform.get(); }  ///< null: shape is in world space
  /// Unit shading normal at a hit of this leaf, world space, as stock orients it.
  Vec3 normal(const Vec3& world_point, const ShapeHit& hit) const;
  Vec2 uv(const Vec3& world_point, const ShapeHit& hit) const;
  void set_inverse(bool inverse) override;

 private:
  Bounds stock_bounds() const;
  /// ask(ray in the shape) fills the arena's hits.
  template <class Ask>
  void gather(const Ray& ray, std::vector<Hit>& hits, HitArena& arena, Ask&& ask) const;
  bool shape_nearest(const Ray&, double t_min, double t_max, ShapeHit&) const;
  bool unclipped_nearest(const Ray&, double t_min, double t_max, ShapeHit&, HitArena&) const;
  /// The direction keeps its length, so that t is the same in both spaces.
  Ray to_shape(const Ray& ray) const {
    return {m_transform->inverse_point(ray.origin), m_transform->inverse_vector(ray.direction)};
  }
  Ball surface_ball() const override { return first_ball(); }
  void clips_have_changed() override;

  std::unique_ptr<Shape> m_shape;
  std::unique_ptr<const Transform> m_transform;  ///< apart: few have one, and it is large
  Bounds m_box;  ///< of the shape, in the world
  bool m_turns_normal = false;
};

enum class CsgKind { kUnion, kIntersection, kDifference, kMerge };

/// A difference is the intersection of its first child with the inverses of the others (which
/// the constructor inverts); bounds of children are taken when it is built, so children come
/// complete: their inverse, clips and bounding set before.
class Csg final : public Object {
 public:
  Csg(CsgKind kind, std::vector<std::unique_ptr<Object>> children);
  ~Csg() override;
  std::string_view name() const override;
  Bounds bounds() const override;
  bool nearest(const Ray&, double t_min, double t_max, Hit&, HitArena&) const override;
  void all(const Ray&, double t_min, double t_max, std::vector<Hit>&, HitArena&) const override;
  bool any(const Ray&, double t_min, double t_max, HitArena&) const override;
  bool inside(const Vec3& p) const override;
  void leaves(std::vector<const Leaf*>& out) const override;
  void drop_shortcuts() override;
  void set_inverse(bool inverse) override;
  Bounds solid_bounds() const override;
  bool solid_leaves_bounds() const override;
  Bounds void_bounds() const override;
  Ball solid_ball() const override;
  bool lies_in_parts() const override { return m_lies_in_parts; }
  bool is_closed() const override;

  /// After `inverse`: what it works as. Only kUnion may be split into its parts.
  CsgKind kind() const { return m_kind; }
  const std::vector<std::unique_ptr<Object>>& children() const { return m_children; }
  /// Where parts leave their bounds (solid_leaves_bounds()): the box that rays must meet, in place of that of the
  /// parts' boxes. Before clips and bounding are set.
  void set_box(const Bounds& box);
  /// Once the whole is complete, which no other CSG has as a part and which is not split: rays that meet its box see
  /// all of the parts that leave theirs, as stock asks parts without a look at their boxes.
  void open_parts();
  /// `split_union off`: its parts stay together, and count as one solid.
  void keep_whole() { m_kept_whole = true; }
  bool is_kept_whole() const { return m_kept_whole; }
  /// For the scene compiler, which hands an unclipped top-level union's parts to the hierarchy.
  std::vector<std::unique_ptr<Object>> take_children() { return std::move(m_children); }

 private:
  /// A child's boxes, so that most rays and points need not ask it.
  struct Fence {
    Bounds surface;  ///< of its surface, cut by what the siblings leave of it
    Bounds decide;   ///< where inside() must be asked; elsewhere the answer is `beyond`
    bool beyond = false;
  };
  struct Search;
  struct Chord;
  struct Hidden;
  static constexpr std::size_t kNobody = ~std::size_t{0};
  static constexpr std::size_t kHidden = kNobody - 1;

  /// Calls visit(child, t_max&, chord) for the children that the ray may meet.
  template <class Visit>
  void for_children_met(const Ray& ray, double t_min, double t_max, HitArena& arena, Visit&& visit) const;
  template <class Visit>
  void for_boxes_met(const Ray& ray, double t_min, double t_max, Visit&& visit) const;
  const std::vector<Hit>& crossings(std::size_t child, const Ray& ray, double t_min, double t_max, const Chord* chord,
                                    std::vector<Hit>& list, HitArena& arena) const;
  void choose_tests();
  bool hides_parts() const;
  bool is_unseen(std::size_t child, RayKind kind) const;
  bool child_inside(std::size_t child, const Vec3& p) const;
  bool any_inside(const Vec3& p, std::size_t except) const;
  bool every_inside(const Vec3& p, std::size_t except) const;
  bool begins_or_ends(const Ray& ray, double t) const;
  bool keeps(std::size_t child, const Ray& ray, double t, const Chord* chord, Hidden& hidden, const HitArena& arena) const;
  bool any_seen_inside(const Vec3& p, std::size_t except, RayKind kind) const;
  bool kept_nearest(const Ray&, double t_min, double t_max, Hit&, HitArena&) const;
  void fence_children();
  void open_parts(const Bounds& whole);
  static Fence fence_of(const Object& child);
  void fill_fences() const;
  Ball surface_ball() const override;
  const Search& search() const;
  void build_search() const;

  CsgKind m_kind;
  std::string_view m_name;
  Bounds m_surface, m_solid, m_void;  ///< before own clips
  bool m_leaves_bounds = false;       ///< a child's solid does
  bool m_lies_in_parts = false;
  bool m_kept_whole = false;
  bool m_closed = false;              ///< all children are
  bool m_asks_boxes = true;           ///< of few children; else their own tests turn rays away as well
  /// Of an intersection of few: a closed part, in whose solid all that is kept lies. Else nobody, or
  /// kHidden where some rays do not see some parts of what is joined.
  std::size_t m_core = kNobody;
  mutable std::vector<Fence> m_fences;  ///< one a child; of many that are joined, made by search()
  std::unique_ptr<Search> m_search;   ///< where there are many children
  std::vector<std::unique_ptr<Object>> m_children;
};

}  // namespace lentray::core
