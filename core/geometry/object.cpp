#include "core/geometry/object.h"

namespace lentray::core {

std::vector<Hit>& HitArena::acquire() {
  if (m_used == m_lists.size()) m_lists.push_back(std::make_unique<std::vector<Hit>>());
  std::vector<Hit>& list = *m_lists[m_used++];
  list.clear();
  return list;
}

bool Object::passes_clips(const Vec3& p) const {
  for (const auto& clip : clips()) {
    if (!clip->inside(p)) return false;
  }
  return true;
}

bool Object::passes_bounding(const Ray& ray, HitArena& arena) const {
  for (const auto& bound : bounding()) {
    // Most rays that come here meet it.
    if (!bound->any(ray, 0.0, Bounds::kInf, arena) && !bound->inside(ray.origin)) return false;
  }
  return true;
}

void Object::fit_ball() {
  m_ball = surface_ball();
  if (!m_limits) return;
  for (const auto& clip : m_limits->clips) m_ball = smaller(m_ball, clip->solid_ball());
  for (const auto& bound : m_limits->bounding) m_ball = smaller(m_ball, bound->solid_ball());
}

Bounds Object::limited(Bounds b) const {
  if (!m_limits) return b;
  for (const auto& clip : m_limits->clips) {
    if (!clip->solid_leaves_bounds()) b.intersect(clip->solid_bounds());
  }
  if (b.is_empty()) return Bounds();
  if (b.is_finite()) return b;
  // Rays that meet the bounds show what lies beyond them, too: these alone count, as in stock.
  Bounds common = Bounds::everything();
  for (const auto& bound : m_limits->bounding) {
    Bounds box = bound->solid_bounds();
    box.include(bound->bounds());
    common.intersect(box);
  }
  if (common.is_empty()) return Bounds();
  return common.is_finite() ? common : b;
}

}  // namespace lentray::core
