#include "core/object/object.h"

#include <algorithm>

#include "core/object/leaf.h"

namespace lentray::core {

bool Object::passes_clips(const Vec3& p) const {
  for (const auto& clip : clips()) {
    if (!clip->inside(p)) return false;
  }
  return true;
}

bool Object::passes_gates(const Ray& ray, const RayQuery& query) const {
  for (const auto& gate : gates()) {
    // Most rays that come here meet it.
    if (!gate->any(ray, 0.0, Bounds::kInf, query) && !gate->inside(ray.origin)) return false;
  }
  return true;
}

void Object::fit_ball() {
  m_ball = surface_ball();
  if (!m_limits) return;
  for (const auto& clip : m_limits->clips) m_ball = smaller(m_ball, clip->solid_ball());
  for (const auto& gate : m_limits->gates) m_ball = smaller(m_ball, gate->solid_ball());
}

Bounds Object::limited(Bounds b) const {
  if (!m_limits) return b;
  for (const auto& clip : m_limits->clips) {
    if (!clip->is_gated()) b.intersect(clip->solid_bounds());
  }
  if (b.is_empty()) return Bounds();
  if (b.is_finite()) return b;
  // Rays that meet the gates show what lies beyond them, too. So the gates' box holds no surface, but where
  // there is no other box it stands for one.
  Bounds common = Bounds::everything();
  for (const auto& gate : m_limits->gates) {
    Bounds box = gate->solid_bounds();
    box.include(gate->bounds());
    common.intersect(box);
  }
  if (common.is_empty()) return Bounds();
  return common.is_finite() ? common : b;
}

bool is_seen_afar(const Object& object) {
  const auto is_one = [](const Leaf* leaf) {
    const std::string_view name = leaf->name();
    return leaf->transform() || name == "box" || name == "cylinder" || name == "cone";
  };
  if (const auto* leaf = dynamic_cast<const Leaf*>(&object)) return is_one(leaf);
  std::vector<const Leaf*> leaves;
  object.leaves(leaves);
  return std::ranges::any_of(leaves, is_one);
}

}  // namespace lentray::core
