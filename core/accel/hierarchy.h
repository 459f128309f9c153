// The bounding hierarchy over a scene's finite objects, plus the list of infinite ones.
// World space. Conservative: a box test never loses a hit the object itself would report,
// whatever the scale (stored boxes are floats rounded outwards, tests allow for every rounding).
// Opacity and flags of the objects are taken when it is built. Scenes where some objects cast no
// shadow, or a filtered one, hold two further trees for shadow rays.
// Immutable; any number of threads. Queries are templates on the counting policy, so that not
// counting costs nothing.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "core/accel/accelerator.h"
#include "core/base/counters.h"
#include "core/object/object.h"

namespace lentray::core {

class RayBundle;
struct BundleHits;

class Hierarchy {
 public:
  /// Borrows the objects. Other accelerators are for comparison and tests; `portable` keeps the
  /// tree from using AVX2 where there is any (the answers are the same).
  explicit Hierarchy(const std::vector<std::unique_ptr<Object>>& objects,
                     Accelerator accelerator = Accelerator::kBvh, bool portable = false);
  ~Hierarchy();

  /// Nearest hit with t_min < t < t_max, and at most kFarthest unless is_seen_afar(). Ties (equal t)
  /// go to the object whose box the ray enters first, then to an infinite one, then to the object
  /// first in the scene, so that the answer does not depend on the order of traversal.
  bool nearest(const Ray& ray, double t_min, double t_max, RayKind kind, Hit& hit, HitLists& lists,
               Counters* counters) const;

  /// Whether the rays of a bundle can be searched together.
  bool takes_bundles() const;
  /// If so: their nearest hits beyond t_min, the same bits as for each alone. False: nothing is known, for the
  /// rays are too far apart. The bundle is filled up.
  bool nearest(const RayBundle& rays, double t_min, RayKind kind, BundleHits& hits,
               HitLists& lists) const;

  /// Any opaque object (Object::is_opaque) hit with t_min < t < t_max, or null. Shadow rays.
  const Object* any_opaque(const Ray& ray, double t_min, double t_max, HitLists& lists,
                           Counters* counters) const;

  /// The only opaque object that any ray may meet between t_min and 1 which begins with those of the bundle and
  /// whose direction lies between theirs, number by number; null: none is met. False: there may be several. Where
  /// takes_bundles(); the bundle is filled up.
  bool only_opaque(const RayBundle& rays, double t_min, const Object*& object) const;

  /// Every hit of objects that are not opaque, or the `nearest` of each alone, unsorted; shadow rays
  /// filtering coloured shadows.
  void all_transparent(const Ray& ray, double t_min, double t_max, bool nearest,
                       std::vector<Hit>& hits, HitLists& lists, Counters* counters) const;

  /// The objects whose inside holds the point, in the scene's order; replaces `out`. Every solid counts, hollow
  /// ones and ones without an `interior` too, and each part of a union that is split. Solids without end,
  /// such as the half of space behind a disc, count within the box of their surface.
  void containing(const Vec3& p, std::vector<const Object*>& out) const;

  /// Of all objects that can be met.
  const Bounds& bounds() const;
  bool has_infinite() const;
  std::size_t memory() const;
  struct Statistics {
    std::size_t nodes = 0, leaves = 0, objects = 0, infinite = 0;
    int depth = 0;
    std::size_t cells = 0, entries = 0;  ///< of a grid, and objects in its cells
  };
  Statistics statistics() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> m_impl;
};

}  // namespace lentray::core
