// Which objects hold a point. World space. Any number of threads. Few questions are answered from a
// list: the hierarchy is built when there are more, for most pictures ask once.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
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
  const WideBvh& tree() const;

  std::vector<Solid> m_bounded, m_unbounded;
  mutable std::atomic<int> m_asked{0};
  mutable std::once_flag m_once;
  mutable WideBvh m_tree;  ///< over m_bounded; see tree()
};

}  // namespace lentray::core
