#include "core/shape/cone.h"

#include "core/numeric/bounds_help.h"
#include "core/numeric/roots.h"

namespace lentray::core {

Cone::Cone(const Vec3& base, double base_radius, const Vec3& cap, double cap_radius, bool open)
    : m_base(base), m_axis(normalized(cap - base)), m_length(length(cap - base)),
      m_base_radius(std::fabs(base_radius)), m_cap_radius(std::fabs(cap_radius)),
      m_slope(m_length > 0.0 ? (m_cap_radius - m_base_radius) / m_length : 0.0), m_open(open) {}

Bounds Cone::box(const Transform* move) const {
  if (is_degenerate()) return {};
  const Transform t = move ? *move : Transform();
  Bounds b = circle_bounds(m_base, m_axis, m_base_radius, t);
  b.include(circle_bounds(m_base + m_axis * m_length, m_axis, m_cap_radius, t));
  return padded(b);
}

/// Through both ends' circles, if its centre lies between them; else that of the larger one.
Ball Cone::ball() const {
  if (is_degenerate()) return {};
  const double squares = (m_cap_radius - m_base_radius) * (m_cap_radius + m_base_radius);
  const double height = std::clamp(0.5 * (m_length + squares / m_length), 0.0, m_length);
  return {m_base + m_axis * height,
          std::max(std::hypot(height, m_base_radius), std::hypot(m_length - height, m_cap_radius))};
}

void Cone::hull(std::vector<Vec3>& points) const {
  if (is_degenerate()) return;
  add_around_circle(m_base, m_axis, m_base_radius, points);
  add_around_circle(m_base + m_axis * m_length, m_axis, m_cap_radius, points);
}

/// The crossings of the whole line, 0 to 2, ascending; none if none is beyond t_min. Between its ends' planes the cone is
/// convex, so that its solid is one stretch of the line: f = (distance from axis)^2 - radius^2
/// is not positive there. An end's crossing is that of its plane to the last bit, so that one that stands on a
/// plane ties with it.
int Cone::crossings(const Ray& ray, double t_min, Crossing out[2]) const {
  if (is_degenerate()) return 0;
  // Start at the point nearest to the centre, so that far origins do not cost digits.
  const Vec3 to_base = m_base - ray.origin;
  const double shift =
      dot(to_base + m_axis * (0.5 * m_length), ray.direction) / dot(ray.direction, ray.direction);
  const Vec3 o = ray.direction * shift - to_base;
  const double oz = dot(o, m_axis), dz = dot(ray.direction, m_axis);
  const Vec3 op = o - m_axis * oz, dp = ray.direction - m_axis * dz;
  const double ro = m_base_radius + m_slope * oz, rd = m_slope * dz;
  const double a = dot(dp, dp) - rd * rd, b = 2.0 * (dot(op, dp) - ro * rd);
  const double c = dot(op, op) - ro * ro;
  double root[2];
  const int n = solve_quadratic(a, b, c, root);
  if (n == 0 && c > 0.0) return 0;
  const bool rising =
      n > 0 && (a == 0.0 ? b > 0.0 : 2.0 * a * root[0] + b > 0.0);  // f at the first
  for (int i = 0; i < n; ++i) root[i] += shift;
  if (n == 2 && a > 0.0 && !(root[1] > t_min)) return 0;
  Crossing in{-Bounds::kInf, kSide}, leave{Bounds::kInf, kSide};
  if (dz == 0.0) {
    if (oz < 0.0 || oz > m_length) return 0;
  } else {
    const double above = dot(to_base, m_axis);
    const double base = above / dz, cap = (above + m_length) / dz;
    const bool up = dz > 0.0;
    in = up ? Crossing{base, kBase} : Crossing{cap, kCap};
    leave = up ? Crossing{cap, kCap} : Crossing{base, kBase};
  }
  double lo = -Bounds::kInf, hi = Bounds::kInf;  // where f <= 0
  if (n == 2 && a > 0.0) {
    lo = root[0];
    hi = root[1];
  } else if (n == 2) {
    // Outside the roots, on two different halves of the double cone: take the one between the ends.
    const double before = std::min(root[0], leave.t) - in.t,
                 after = leave.t - std::max(root[1], in.t);
    (before > after ? hi : lo) = before > after ? root[0] : root[1];
  } else if (n == 1) {
    (rising ? hi : lo) = root[0];
    if (a > 0.0 && b == 0.0) lo = hi = root[0];
  }
  if (m_open) {
    int kept = 0;
    for (int i = 0; i < n; ++i) {
      if (root[i] >= in.t && root[i] <= leave.t) out[kept++] = {root[i], kSide};
    }
    return kept;
  }
  if (lo > in.t) in = {lo, kSide};
  if (hi < leave.t) leave = {hi, kSide};
  if (!(in.t <= leave.t) || !std::isfinite(in.t) || !std::isfinite(leave.t)) return 0;
  out[0] = in;
  out[1] = leave;
  return 2;
}

bool Cone::nearest(const Ray& ray, double t_min, double t_max, ShapeHit& hit) const {
  Crossing found[2];
  return first_between(found, crossings(ray, t_min, found), t_min, t_max, hit);
}

void Cone::all(const Ray& ray, double t_min, double t_max, ShapeHits& hits) const {
  Crossing found[2];
  append_between(found, crossings(ray, t_min, found), t_min, t_max, hits);
}

bool Cone::within(const Vec3& p) const {
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

Vec3 Cone::normal(const Vec3& p, const ShapeHit& hit) const {
  if (hit.element == kBase) return -m_axis;
  if (hit.element == kCap) return m_axis;
  const Vec3 q = p - m_base;
  const double z = dot(q, m_axis);
  return (q - m_axis * z) - m_axis * (m_slope * (m_base_radius + m_slope * z));
}

std::unique_ptr<Shape> Cone::baked(const Transform& t) const {
  const double scale = similarity_scale(t);
  if (scale == 0.0) return nullptr;
  return std::make_unique<Cone>(t.point(m_base), m_base_radius * scale,
                                t.point(m_base + m_axis * m_length), m_cap_radius * scale, m_open);
}

}  // namespace lentray::core
