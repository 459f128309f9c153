// A crossing of a ray with an object of the scene, and a thread's lists of crossings. World space.
#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/base/bounds.h"
#include "core/object/attributes.h"
#include "core/shape/shape.h"

namespace lentray::core {

class Leaf;
class Object;

/// A crossing of a ray with an object.
struct Hit {
  double t = Bounds::kInf;
  const Leaf* leaf = nullptr;      ///< whose surface it is: gives normal and material
  const Object* object = nullptr;  ///< the object of the scene's list that it belongs to
  ShapeHit shape;                  ///< in the leaf's space
  std::uint32_t place = 0;         ///< where all hits are asked for: infinite objects, then the
                                   ///< others, in the order of the scene; a CSG's own meanwhile
};

/// Scratch lists of hits for nested CSG; one a thread; lists are reused, never shrunk.
class HitLists {
 public:
  std::vector<Hit>& acquire();
  void release() {
    assert(m_used > 0);
    --m_used;
  }
  ShapeHits shape_hits;

 private:
  std::vector<std::unique_ptr<std::vector<Hit>>> m_lists;
  std::size_t m_used = 0;
};

/// What comes with a ray: the thread's lists, and the ray's kind, for CSG has parts that some kinds do not see.
struct RayQuery {
  HitLists& lists;
  RayKind kind;
};

}  // namespace lentray::core
