#include "core/scene/solid_index.h"

#include <algorithm>

namespace lentray::core {

SolidIndex::SolidIndex(const std::vector<std::unique_ptr<Object>>& objects,
                       const std::vector<std::uint32_t>& groups) {
  m_bounded.reserve(objects.size());
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const Object& object = *objects[i];
    const Solid solid{&object, object.solid_bounds(), static_cast<std::uint32_t>(i), groups[i]};
    if (solid.bounds.is_empty()) continue;
    (solid.bounds.is_finite() ? m_bounded : m_unbounded).push_back(solid);
  }
}

const WideBvh& SolidIndex::tree() const {
  std::call_once(m_once, [this] {
    std::vector<Bounds> boxes;
    boxes.reserve(m_bounded.size());
    for (const Solid& solid : m_bounded) boxes.push_back(solid.bounds);
    m_tree = WideBvh(boxes);
  });
  return m_tree;
}

void SolidIndex::containing(const Vec3& p, std::vector<const Object*>& out) const {
  out.clear();
  std::vector<const Solid*> found;  // no memory unless there are any
  const auto test = [&](const Solid& solid) {
    if (solid.bounds.contains(p) && solid.object->inside(p)) found.push_back(&solid);
  };
  for (const Solid& solid : m_unbounded) test(solid);
  constexpr int kFew = 8;  // questions; a tree costs as much as dozens of looks at the list
  if (m_asked.load(std::memory_order_relaxed) < kFew) {
    m_asked.fetch_add(1, std::memory_order_relaxed);
    for (const Solid& solid : m_bounded) test(solid);
  } else {
    const WideBvh& tree = this->tree();
    tree.at_point(p, [&](std::uint32_t first, std::uint32_t count) {
      for (std::uint32_t i = 0; i < count; ++i) test(m_bounded[tree.order()[first + i]]);
      return false;
    });
  }
  if (found.empty()) return;
  std::sort(found.begin(), found.end(),
            [](const Solid* a, const Solid* b) { return a->index < b->index; });
  for (std::size_t i = 0; i < found.size(); ++i) {
    const Solid& s = *found[i];
    const bool counted = std::any_of(found.begin(), found.begin() + static_cast<long>(i),
                                     [&](const Solid* o) {
                                       return o->group == s.group &&
                                              o->object->attributes().interior ==
                                                  s.object->attributes().interior;
                                     });
    if (!counted) out.push_back(s.object);
  }
}

}  // namespace lentray::core
