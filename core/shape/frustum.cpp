#include "core/shape/frustum.h"

#include "core/numeric/bounds_help.h"

namespace lentray::core {

Frustum::Frustum(const Vec3& base, double base_radius, const Vec3& cap, double cap_radius,
                 bool open)
    : m_base(base), m_axis(normalized(cap - base)), m_length(length(cap - base)),
      m_base_radius(std::fabs(base_radius)), m_cap_radius(std::fabs(cap_radius)),
      m_slope(m_length > 0.0 ? (m_cap_radius - m_base_radius) / m_length : 0.0), m_open(open) {}

Bounds Frustum::box(const Transform* move) const {
  if (is_degenerate()) return {};
  const Transform t = move ? *move : Transform();
  Bounds b = circle_bounds(m_base, m_axis, m_base_radius, t);
  b.include(circle_bounds(cap(), m_axis, m_cap_radius, t));
  return padded(b);
}

/// Through both ends' circles, if its centre lies between them; else that of the larger one.
Ball Frustum::ball() const {
  if (is_degenerate()) return {};
  const double squares = (m_cap_radius - m_base_radius) * (m_cap_radius + m_base_radius);
  const double height = std::clamp(0.5 * (m_length + squares / m_length), 0.0, m_length);
  return {m_base + m_axis * height,
          std::max(std::hypot(height, m_base_radius), std::hypot(m_length - height, m_cap_radius))};
}

void Frustum::hull(std::vector<Vec3>& points) const {
  if (is_degenerate()) return;
  add_around_circle(m_base, m_axis, m_base_radius, points);
  add_around_circle(cap(), m_axis, m_cap_radius, points);
}

bool Frustum::within(const Vec3& p) const {
  if (is_degenerate()) return false;
  const Vec3 q = p - m_base;
  const double z = dot(q, m_axis);
  const Vec3 across = q - m_axis * z;
  const double r = m_base_radius + m_slope * z;
  const double widest = std::max(m_base_radius, m_cap_radius);
  // The surface itself is outside of a closed one and inside of an open one.
  const double slack = m_open ? kRoundTolerance : -kRoundTolerance;
  return dot(across, across) <= r * r + slack * widest * widest && z >= -slack * m_length &&
         z <= m_length * (1.0 + slack);
}

Side Frustum::side(const Vec3& p, double margin) const {
  if (is_degenerate()) return Side::kNear;
  const Vec3 q = p - m_base;
  const double z = dot(q, m_axis);
  if (z < -margin || z > m_length + margin) return Side::kOutside;
  const Vec3 across = q - m_axis * z;
  const double r = m_base_radius + m_slope * z;
  const double widest = std::max({m_base_radius, m_cap_radius, std::fabs(r)});
  const double wide = margin * (1.0 + std::fabs(m_slope));
  const Side of_side = side_by(dot(across, across) - r * r, (2.0 * widest + wide) * wide);
  const bool is_near_end = z < margin || z > m_length - margin;
  return of_side == Side::kInside && is_near_end ? Side::kNear : of_side;
}

Vec3 Frustum::normal(const Vec3& p, const ShapeHit& hit) const {
  if (hit.element == kBase) return -m_axis;
  if (hit.element == kCap) return m_axis;
  const Vec3 q = p - m_base;
  const double z = dot(q, m_axis);
  return (q - m_axis * z) - m_axis * (m_slope * (m_base_radius + m_slope * z));
}

}  // namespace lentray::core
