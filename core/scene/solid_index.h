// Which objects hold a point. World space. Immutable once built; any number of threads.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/accel/wide_bvh.h"
#include "core/geometry/object.h"

namespace lentray::core {

class SolidIndex {
 public:
  /// Borrows the objects. groups[i]: number of the top-level object that objects[i] is a part of.
  /// Objects that cannot hold anything are left out.
  SolidIndex(const std::vector<std::unique_ptr<Object>>& objects,
             const std::vector<std::uint32_t>& groups);

  /// Replaces `out`, scene order; of one group's parts with one interior only the first.
  void containing(const Vec3& p, std::vector<const Object*>& out) const;

 private:
  struct Solid {
    const Object* object = nullptr;
    Bounds bounds;
    std::uint32_t index = 0, group = 0;
  };
  std::vector<Solid> m_bounded;    ///< by place in the tree
  std::vector<Solid> m_unbounded;
  WideBvh m_tree;
};

}  // namespace lentray::core
