// Constructive solid geometry: unions, intersections, differences and merges of objects.
// Space: world. Immutable while rendering; scratch memory comes from the caller's HitLists.
// Source: reference manual 3.7, "Constructive Solid Geometry".
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

#include "core/object/object.h"

namespace lentray::core {

class ConvexParts;

enum class CsgKind { kUnion, kIntersection, kDifference, kMerge };

/// A difference is the intersection of its first child with the inverses of the others (which
/// the constructor inverts); bounds of children are taken when it is built, so children come
/// complete: their inverse and clips set before.
class Csg final : public Object {
 public:
  Csg(CsgKind kind, std::vector<std::unique_ptr<Object>> children);
  ~Csg() override;
  std::string_view name() const override;
  Bounds bounds() const override;
  bool nearest(const Ray&, double t_min, double t_max, Hit&, const RayQuery&) const override;
  void all(const Ray&, double t_min, double t_max, std::vector<Hit>&,
           const RayQuery&) const override;
  bool any(const Ray&, double t_min, double t_max, const RayQuery&) const override;
  bool inside(const Vec3& p) const override;
  void leaves(std::vector<const Leaf*>& out) const override;
  void set_inverse(bool inverse) override;
  Bounds solid_bounds() const override;
  Bounds void_bounds() const override;
  Ball solid_ball() const override;

  /// After `inverse`: what it works as. Only kUnion may be split into its parts.
  CsgKind kind() const { return m_kind; }
  const std::vector<std::unique_ptr<Object>>& children() const { return m_children; }
  /// `split_union off`: its parts stay together, and count as one solid.
  void keep_whole() { m_kept_whole = true; }
  bool is_kept_whole() const { return m_kept_whole; }
  /// For complete() of core/object/object.h: the hierarchies over many children.
  void build_search();
  /// For the scene compiler, which hands an unclipped top-level union's parts to the hierarchy.
  std::vector<std::unique_ptr<Object>> take_children() { return std::move(m_children); }

 private:
  /// A child's boxes, with which most rays and points are decided without the child.
  struct Fence {
    Bounds surface;  ///< of its surface, cut by what the siblings leave of it
    Bounds decide;   ///< where inside() must be asked; elsewhere the answer is `beyond`
    bool beyond = false;
  };
  struct Search;
  struct Chord;
  struct Overlap;
  struct Hidden;
  static constexpr std::size_t kNobody = ~std::size_t{0};
  /// How its crossings are found.
  enum class Way : std::uint8_t {
    kParts,   ///< each part's, and what the others keep of them
    kHidden,  ///< the same of a union or merge with parts that are invisible to some rays
    kOverlap,  ///< of an intersection of many convex parts, and of the inverse of one: where all overlap
    kConvex,  ///< of few convex parts: where the ray is in each; what that leaves open as kParts
  };

  /// Calls visit(child, t_max&, chord) for the children that the ray may hit.
  template <bool kHides, class Visit>
  void for_children_met(const Ray& ray, double t_min, double t_max, const RayQuery& query,
                        Visit&& visit) const;
  template <class Visit>
  void for_boxes_met(const Ray& ray, double t_min, double t_max, Visit&& visit) const;
  const std::vector<Hit>& crossings(std::size_t child, const Ray& ray, double t_min, double t_max,
                                    const Chord* chord, std::vector<Hit>& list,
                                    const RayQuery& query) const;
  void choose_tests();
  bool is_overlap() const;
  template <class Visit>
  void for_kept_of_overlap(const Ray& ray, double t_min, double t_max, const RayQuery& query,
                           Visit&& visit) const;
  bool hides_parts() const;
  bool is_unseen(std::size_t child, RayKind kind) const;
  bool child_inside(std::size_t child, const Vec3& p) const;
  bool any_inside(const Vec3& p, std::size_t except) const;
  bool every_inside(const Vec3& p, std::size_t except) const;
  bool begins_or_ends(const Ray& ray, double t) const;
  template <bool kHides>
  bool keeps(std::size_t child, const Ray& ray, double t, const Chord* chord, Hidden& hidden,
             const RayQuery& query) const;
  bool any_seen_inside(const Vec3& p, std::size_t except, RayKind kind) const;
  bool kept_nearest(const Ray&, double t_min, double t_max, Hit&, const RayQuery&) const;
  // All other ways than kParts: apart, for few ask for them.
  bool special_nearest(const Ray&, double t_min, double t_max, Hit&, const RayQuery&) const;
  bool special_any(const Ray&, double t_min, double t_max, const RayQuery&) const;
  void special_all(const Ray&, double t_min, double t_max, std::vector<Hit>&,
                   const RayQuery&) const;
  // kHides: the way is kHidden.
  template <bool kHides>
  bool nearest_of_parts(const Ray&, double t_min, double t_max, Hit&, const RayQuery&) const;
  template <bool kHides>
  bool any_of_parts(const Ray&, double t_min, double t_max, const RayQuery&) const;
  template <bool kHides>
  void all_of_parts(const Ray&, double t_min, double t_max, std::vector<Hit>&,
                    const RayQuery&) const;
  void fence_children();
  static Fence fence_of(const Object& child);
  Ball surface_ball() const;

  CsgKind m_kind;
  std::string_view m_name;
  Bounds m_surface, m_solid, m_void;  ///< before own clips
  bool m_kept_whole = false;
  bool m_asks_boxes = true;  ///< of few children; false where their own tests are as quick
  Way m_way = Way::kParts;
  /// The index of a closed part that contains all of an intersection of few parts; else kNobody.
  std::size_t m_core = kNobody;
  std::vector<Fence> m_fences;  ///< one a child; of many that are joined, made by build_search()
  std::unique_ptr<Search> m_search;  ///< where there are many children, from build_search() on
  std::vector<std::unique_ptr<Object>> m_children;
  std::unique_ptr<const ConvexParts> m_convex;  ///< where the way is kConvex
};

}  // namespace lentray::core
