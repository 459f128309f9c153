// Which objects hold a point. World space. Any number of threads. Few questions are answered by asking
// all objects: a list and a hierarchy are made when there are more, for most pictures ask once.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "core/bvh/wide_bvh.h"
#include "core/object/object.h"

namespace lentray::core {

class SolidIndex {
 public:
  /// Borrows the objects and their list.
  explicit SolidIndex(const std::vector<std::unique_ptr<Object>>& objects) : m_objects(objects) {}

  /// Replaces `out`, scene order. Parts of a union that is split count each; solids without end, such as the half
  /// of space behind a disc, count within the box of their surface.
  void containing(const Vec3& p, std::vector<const Object*>& out) const;

 private:
  struct Solid {
    const Object* object = nullptr;
    Bounds bounds;
    std::uint32_t index = 0;
  };
  Solid solid(std::size_t i) const;
  /// Makes what follows it, when it is first called.
  const WideBvh& tree() const;

  const std::vector<std::unique_ptr<Object>>& m_objects;
  mutable std::atomic<int> m_asked{0};
  mutable std::once_flag m_once;
  mutable std::vector<Solid> m_bounded, m_unbounded;  ///< but objects that cannot hold anything
  mutable WideBvh m_tree;                             ///< over m_bounded
};

}  // namespace lentray::core
