#include "core/scene/solid_index.h"

#include <algorithm>

namespace lentray::core {

/// Of solids without end what lies beyond the box of the surface does not count: half of space is inside a disc.
SolidIndex::Solid SolidIndex::solid(std::size_t i) const {
  const Object& object = *m_objects[i];
  Bounds box = object.solid_bounds();
  const Bounds surface = object.bounds();
  if (!box.is_finite() && surface.is_finite()) box.intersect(surface);
  return {&object, box, static_cast<std::uint32_t>(i)};
}

const WideBvh& SolidIndex::tree() const {
  std::call_once(m_once, [this] {
    m_bounded.reserve(m_objects.size());
    for (std::size_t i = 0; i < m_objects.size(); ++i) {
      const Solid one = solid(i);
      if (one.bounds.is_empty()) continue;
      (one.bounds.is_finite() ? m_bounded : m_unbounded).push_back(one);
    }
    std::vector<Bounds> boxes;
    boxes.reserve(m_bounded.size());
    for (const Solid& solid : m_bounded) boxes.push_back(solid.bounds);
    m_tree = WideBvh(boxes);
  });
  return m_tree;
}

void SolidIndex::containing(const Vec3& p, std::vector<const Object*>& out) const {
  out.clear();
  std::vector<Solid> found;  // no memory unless there are any
  const auto test = [&](const Solid& solid) {
    if (solid.bounds.contains(p) && solid.object->inside(p)) found.push_back(solid);
  };
  constexpr int kFew = 4;  // questions; a tree costs as much as a dozen of looks at all objects
  if (m_asked.load(std::memory_order_relaxed) < kFew) {
    m_asked.fetch_add(1, std::memory_order_relaxed);
    for (std::size_t i = 0; i < m_objects.size(); ++i) test(solid(i));
  } else {
    const WideBvh& tree = this->tree();
    for (const Solid& solid : m_unbounded) test(solid);
    tree.at_point(p, [&](std::uint32_t first, std::uint32_t count) {
      for (std::uint32_t i = 0; i < count; ++i) test(m_bounded[tree.order()[first + i]]);
      return false;
    });
  }
  if (found.empty()) return;
  std::sort(found.begin(), found.end(),
            [](const Solid& a, const Solid& b) { return a.index < b.index; });
  for (const Solid& solid : found) out.push_back(solid.object);
}

}  // namespace lentray::core
