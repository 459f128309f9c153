#include "core/scene/solid_index.h"

#include <algorithm>

namespace lentray::core {

namespace {

/// Of solids without end what lies beyond the box of the surface does not count: half of space is inside a disc.
Bounds box_of(const Object& object) {
  Bounds box = object.solid_bounds();
  const Bounds surface = object.bounds();
  if (!box.is_finite() && surface.is_finite()) box.intersect(surface);
  return box;
}

}  // namespace

SolidIndex::SolidIndex(const std::vector<std::unique_ptr<Object>>& objects) {
  std::vector<Bounds> boxes;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const Solid one{objects[i].get(), box_of(*objects[i]), static_cast<std::uint32_t>(i)};
    if (one.bounds.is_empty()) continue;
    if (!one.bounds.is_finite()) {
      m_unbounded.push_back(one);
      continue;
    }
    m_bounded.push_back(one);
    boxes.push_back(one.bounds);
  }
  m_tree = WideBvh(boxes);
}

void SolidIndex::containing(const Vec3& p, std::vector<const Object*>& out) const {
  out.clear();
  std::vector<Solid> found;  // no memory unless there are any
  const auto test = [&](const Solid& solid) {
    if (solid.bounds.contains(p) && solid.object->inside(p)) found.push_back(solid);
  };
  for (const Solid& solid : m_unbounded) test(solid);
  m_tree.at_point(p, [&](std::uint32_t first, std::uint32_t count) {
    for (std::uint32_t i = 0; i < count; ++i) test(m_bounded[m_tree.order()[first + i]]);
    return false;
  });
  if (found.empty()) return;
  std::sort(found.begin(), found.end(),
            [](const Solid& a, const Solid& b) { return a.index < b.index; });
  for (const Solid& solid : found) out.push_back(solid.object);
}

}  // namespace lentray::core
