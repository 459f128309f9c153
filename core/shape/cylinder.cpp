#include "core/shape/cylinder.h"

#include "core/numeric/bounds_help.h"

namespace lentray::core {

Cylinder::Cylinder(const Vec3& base, const Vec3& cap, double radius, bool open)
    : m_base(base), m_axis(normalized(cap - base)), m_length(length(cap - base)),
      m_radius(std::fabs(radius)), m_open(open) {}

Bounds Cylinder::box(const Transform* move) const {
  if (is_degenerate()) return {};
  const Transform t = move ? *move : Transform();
  Bounds b = circle_bounds(m_base, m_axis, m_radius, t);
  b.include(circle_bounds(cap(), m_axis, m_radius, t));
  return padded(b);
}

Ball Cylinder::ball() const {
  return {m_base + m_axis * (0.5 * m_length), std::hypot(0.5 * m_length, m_radius)};
}

void Cylinder::hull(std::vector<Vec3>& points) const {
  if (is_degenerate()) return;
  add_around_circle(m_base, m_axis, m_radius, points);
  add_around_circle(cap(), m_axis, m_radius, points);
}

/// The crossings of the whole line, 0 to 2, ascending; none if none is beyond t_min. A closed cylinder is convex: what lies
/// between the side's two crossings and between the ends' planes is one stretch of the line. An end's crossing is
/// that of its plane to the last bit, so that one that stands on a plane ties with it.
int Cylinder::crossings(const Ray& ray, double t_min, Crossing out[2]) const {
  if (is_degenerate()) return 0;
  // Start at the point nearest to the centre, so that far origins do not cost digits.
  const Vec3 to_base = m_base - ray.origin;
  const double shift =
      dot(to_base + m_axis * (0.5 * m_length), ray.direction) / dot(ray.direction, ray.direction);
  const Vec3 o = ray.direction * shift - to_base;
  const double oz = dot(o, m_axis), dz = dot(ray.direction, m_axis);
  const Vec3 op = o - m_axis * oz, dp = ray.direction - m_axis * dz;
  const double a = dot(dp, dp), b = dot(op, dp);

  Crossing in{-Bounds::kInf, kSide}, leave{Bounds::kInf, kSide};
  if (a > 1e-30 * dot(ray.direction, ray.direction)) {
    const double middle = -b / a;
    const Vec3 foot = op + dp * middle;
    const double h = m_radius * m_radius - dot(foot, foot);
    if (!(h >= 0.0)) return 0;
    const double half = std::sqrt(h / a);
    in.t = shift + (middle - half);
    leave.t = shift + (middle + half);
    if (!(leave.t > t_min)) return 0;
  } else if (dot(op, op) > m_radius * m_radius) {
    return 0;
  }
  if (m_open) {
    int n = 0;
    for (const Crossing& side : {in, leave}) {
      const double z = oz + dz * (side.t - shift);
      if (z >= 0.0 && z <= m_length) out[n++] = side;
    }
    return n;
  }
  if (dz == 0.0) {
    if (oz < 0.0 || oz > m_length) return 0;
  } else {
    const double above = dot(to_base, m_axis);
    const double base = above / dz, cap = (above + m_length) / dz;
    const bool up = dz > 0.0;
    const double first = up ? base : cap, last = up ? cap : base;
    if (first > in.t) in = {first, up ? kBase : kCap};
    if (last < leave.t) leave = {last, up ? kCap : kBase};
  }
  if (!(in.t <= leave.t)) return 0;
  out[0] = in;
  out[1] = leave;
  return 2;
}

bool Cylinder::nearest(const Ray& ray, double t_min, double t_max, ShapeHit& hit) const {
  Crossing found[2];
  return first_between(found, crossings(ray, t_min, found), t_min, t_max, hit);
}

void Cylinder::all(const Ray& ray, double t_min, double t_max, ShapeHits& hits) const {
  Crossing found[2];
  append_between(found, crossings(ray, t_min, found), t_min, t_max, hits);
}

bool Cylinder::within(const Vec3& p) const {
  if (is_degenerate()) return false;
  const Vec3 q = p - m_base;
  const double z = dot(q, m_axis);
  const Vec3 across = q - m_axis * z;
  // The surface itself is outside of a closed one and inside of an open one.
  const double slack = m_open ? kRoundTolerance : -kRoundTolerance;
  return dot(across, across) <= m_radius * m_radius * (1.0 + slack) && z >= -slack * m_length &&
         z <= m_length * (1.0 + slack);
}

Vec3 Cylinder::normal(const Vec3& p, const ShapeHit& hit) const {
  if (hit.element == kBase) return -m_axis;
  if (hit.element == kCap) return m_axis;
  const Vec3 q = p - m_base;
  return q - m_axis * dot(q, m_axis);
}

std::unique_ptr<Shape> Cylinder::baked(const Transform& t) const {
  const double scale = similarity_scale(t);
  if (scale == 0.0) return nullptr;
  return std::make_unique<Cylinder>(t.point(m_base), t.point(cap()), m_radius * scale, m_open);
}

}  // namespace lentray::core
