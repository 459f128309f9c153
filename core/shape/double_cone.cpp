#include "core/shape/double_cone.h"

#include <cstddef>

namespace lentray::core {

DoubleCone::DoubleCone(const Vec3& base, double base_radius, const Vec3& cap, double cap_radius,
                       bool open)
    : DoubleCone(base, base_radius,
                 base + (cap - base) * (base_radius / (base_radius - cap_radius)), cap, cap_radius,
                 open) {}

DoubleCone::DoubleCone(const Vec3& base, double base_radius, const Vec3& tip, const Vec3& cap,
                       double cap_radius, bool open)
    : m_lower(base, base_radius, tip, 0.0, open), m_upper(tip, 0.0, cap, cap_radius, open) {}

Bounds DoubleCone::box(const Transform* move) const {
  Bounds b = m_lower.box(move);
  b.include(m_upper.box(move));
  return b;
}

void DoubleCone::hull(std::vector<Vec3>& points) const {
  m_lower.hull(points);
  m_upper.hull(points);
}

bool DoubleCone::nearest(const Ray& ray, double t_min, double t_max, ShapeHit& hit) const {
  const bool lower = m_lower.nearest(ray, t_min, t_max, hit);
  ShapeHit other;
  if (!m_upper.nearest(ray, t_min, lower ? hit.t : t_max, other)) return lower;
  hit = other;
  hit.element += kUpper;
  return true;
}

void DoubleCone::all(const Ray& ray, double t_min, double t_max, ShapeHits& hits) const {
  m_lower.all(ray, t_min, t_max, hits);
  const std::size_t first = hits.size();
  m_upper.all(ray, t_min, t_max, hits);
  for (std::size_t i = first; i < hits.size(); ++i) hits[i].element += kUpper;
}

Vec3 DoubleCone::normal(const Vec3& p, const ShapeHit& hit) const {
  if (hit.element < kUpper) return m_lower.normal(p, hit);
  ShapeHit upper = hit;
  upper.element -= kUpper;
  return m_upper.normal(p, upper);
}

}  // namespace lentray::core
