// The nearest hits of the rays of a bundle, found together in the tree of an ObjectTree. World space. The bits are
// those of a search for each ray: culling is conservative, the objects' own tests are the same operations, and the
// nearest hit does not depend on what is asked first.
// Immutable once built; any number of threads.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/accel/object_tree.h"
#include "core/bundle/bundle_walk.h"
#include "core/bundle/ray_bundle.h"

namespace lentray::core {

/// What the rays of a bundle meet. Written over by each search.
struct BundleHits {
  enum class Answer : std::uint8_t {
    kUnknown,  ///< who wants to know asks for the ray alone
    kMissed,
    kMet,
  };
  std::array<Answer, RayBundle::kMost> answer{};
  std::array<Hit, RayBundle::kMost> hit{};
};

class BundleTree {
 public:
  /// Borrows the tree, which stays where it is.
  explicit BundleTree(const ObjectTree& tree);
  /// False: this tree's searches go ray by ray.
  bool works() const { return m_works; }

  struct Query {
    double t_min, t_max;
    std::uint8_t unseen;  ///< objects with one of these flags are passed by
    RayQuery objects;
  };
  /// False: it takes too long, for the rays are too far apart; nothing is known of any. Else kMet or kMissed of
  /// each. The bundle is filled up.
  bool nearest(const RayBundle& rays, const Query& query, BundleHits& hits) const;
  /// The only object that may be met between t_min and 1 by rays whose directions lie between those of the bundle,
  /// number by number, and that begin where it does; null: there is none. False: there may be several. The bundle is
  /// filled up. `unseen`: as Query's.
  bool only_one(const RayBundle& rays, double t_min, std::uint8_t unseen,
                const Object*& object) const;
  std::size_t memory() const { return m_boxes.capacity() * sizeof(PartBox); }

 private:
  class Search;
  class OnlyOne;
  const ObjectTree& m_tree;
  std::vector<PartBox> m_boxes;  ///< one an entry of the tree, by place
  bool m_works;
};

}  // namespace lentray::core
