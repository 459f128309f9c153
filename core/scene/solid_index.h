// Which objects hold a point. World space. Immutable, any number of threads.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/bvh/wide_bvh.h"
#include "core/object/object.h"

namespace lentray::core {

class SolidIndex {
 public:
  /// Borrows the objects.
  explicit SolidIndex(const std::vector<std::unique_ptr<Object>>& objects);

  /// Replaces `out`, scene order. Parts of a union that is split count each.
  void containing(const Vec3& p, std::vector<const Object*>& out) const;

 private:
  struct Solid {
    const Object* object = nullptr;
    Bounds bounds;
    std::uint32_t index = 0;
  };

  std::vector<Solid> m_bounded, m_unbounded;  ///< but objects that cannot hold anything
  WideBvh m_tree;                             ///< over m_bounded
};

}  // namespace lentray::core
