// A difference or intersection all of whose parts are convex: a line is in each of them for one stretch at most.
// What these and points away from all surfaces decide needs no list of hits; the rest is left to the CSG, which
// decides by inside(), and both give the same bits.
// World space. Immutable; any number of threads. Internal to csg*.cpp.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/object/leaf.h"
#include "core/shape/convex.h"

namespace lentray::core {

enum class Answer : std::uint8_t { kNo, kYes, kUnclear };

class ConvexParts {
 public:
  static constexpr std::size_t kMost = 8;
  using Children = std::vector<std::unique_ptr<Object>>;

  /// Null where a child is not such a part. The core is a closed one, which holds all of the whole.
  /// `pairs_count`: where surfaces coincide the whole may have one that both parts seem to hide.
  static std::unique_ptr<const ConvexParts> of(const Children& children, std::size_t core,
                                               bool pairs_count);

  /// As Object's, of a whole without clips. The hit stays as it was unless there is one.
  Answer nearest(const Ray& ray, double t_min, double t_max, Hit& hit) const;
  Answer any(const Ray& ray, double t_min, double t_max) const;
  /// False: unclear, and nothing is appended.
  bool all(const Ray& ray, double t_min, double t_max, std::vector<Hit>& hits) const;

 private:
  struct Part {
    const Leaf* leaf;
    const Transform* move;  ///< null: the shape is in world space
    Convex shape;
    bool is_inverse;
    /// Whether the part surely holds the world's point or surely does not.
    Answer holds(const Vec3& p) const;
    /// The same of a point of the shape's space.
    Answer holds_own(const Vec3& p) const;
  };
  struct Line;
  ConvexParts(std::vector<Part> parts, double reach, bool pairs_count)
      : m_parts(std::move(parts)), m_reach(reach), m_pairs_count(pairs_count) {}
  Answer keeps(const Line& line, std::size_t part, double t) const;
  template <class Visit>
  bool for_crossings(const Ray& ray, double t_min, const double& limit, bool first_alone,
                     Visit&& visit) const;

  std::vector<Part>
      m_parts;     ///< in the order in which they are asked: the core, then the last first
  double m_reach;  ///< the sizes of all that places the parts
  bool m_pairs_count;
};

}  // namespace lentray::core
