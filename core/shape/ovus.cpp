#include "core/shape/ovus.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/numeric/about_axis.h"
#include "core/numeric/bounds_help.h"
#include "core/numeric/roots.h"
#include "core/shape/crossings.h"

namespace lentray::core {
namespace {

constexpr std::uint32_t kBottom = 0, kWaist = 1, kTop = 2;

}  // namespace

// The tube touches a sphere from without where the distance of their centres is the difference of
// their radii.
Ovus::Ovus(double bottom, double top)
    : m_bottom(bottom), m_top(top), m_waist(2.0 * std::max(bottom, top)) {
  const double to_bottom = m_waist - bottom, to_top = m_waist - top;
  m_height = (to_bottom * to_bottom - to_top * to_top + bottom * bottom) / (2.0 * bottom);
  m_spindle = std::sqrt(std::max(0.0, to_bottom * to_bottom - m_height * m_height));
  m_low = -m_height * bottom / to_bottom;
  m_high = bottom + (bottom - m_height) * top / to_top;
}

Bounds Ovus::own_box() const {
  const double widest = std::max({m_bottom, m_top, m_waist - m_spindle});
  return padded({{-widest, -m_bottom, -widest}, {widest, m_bottom + m_top, widest}});
}

/// A convex body: its surface faces d on the sphere or tube whose share of the directions has d.
Bounds Ovus::box_in(const Transform& t) const {
  return support_bounds(t, [&](const Vec3& d) {
    const double size = length(d), across = std::sqrt(d.x * d.x + d.z * d.z);
    if (d.y <= size * m_low / m_bottom) return m_bottom * size;
    if (d.y >= size * (m_high - m_bottom) / m_top) return d.y * m_bottom + m_top * size;
    return d.y * m_height - across * m_spindle + m_waist * size;
  });
}

/// False if the line q + s d, from the place nearest to the lemon's centre, certainly does not meet
/// the lemon beyond s = from: f = (distance from axis + spindle)^2 + y^2 - waist^2 is convex.
bool Ovus::may_meet_waist(const Vec3& q, const Vec3& d, double from) const {
  const double tube2 = m_waist * m_waist, clear = 1e-9 * tube2;
  const double rest = m_spindle * m_spindle - tube2;
  const double across2 = d.x * d.x + d.z * d.z;
  const double nearest = across2 > 0.0 ? -(q.x * d.x + q.z * d.z) / across2 : 0.0;
  const double x = q.x + nearest * d.x, z = q.z + nearest * d.z;
  if (dot(q, q) + 2.0 * m_spindle * std::sqrt(x * x + z * z) + rest > clear) return false;
  const Vec3 at = q + d * from;
  const double from_axis = std::sqrt(at.x * at.x + at.z * at.z);
  const bool outside = dot(at, at) + 2.0 * m_spindle * from_axis + rest > clear;
  return !(outside && dot(at, d) * from_axis + m_spindle * (at.x * d.x + at.z * d.z) > 0.0);
}

template <class Visit>
void Ovus::crossings(const Ray& ray, double t_min, double t_max, Visit&& visit) const {
  constexpr double kWider = 1e-9;
  const double speed = length(ray.direction);
  const Vec3 d = ray.direction / speed;
  const Vec3 middle{0.0, m_height, 0.0};
  // Counted from the point nearest to the tube's plane of symmetry's middle.
  const double shift = dot(middle - ray.origin, d);
  const Vec3 p = ray.origin + d * shift;
  const auto report = [&](double s, std::uint32_t element) {
    const double y = p.y + s * d.y;
    const bool mine = element == kBottom ? y < m_low
                      : element == kTop  ? y > m_high
                                         : y >= m_low && y <= m_high;
    if (mine) visit((s + shift) / speed, element, 0.0);
  };
  const auto sphere = [&](double centre, double radius, std::uint32_t element) {
    const Vec3 from = p - Vec3{0.0, centre, 0.0};
    const double b = dot(from, d), under = radius * radius - dot(from, from) + b * b;
    if (!(under > 0.0)) return;
    report(-b - std::sqrt(under), element);
    report(-b + std::sqrt(under), element);
  };
  sphere(0.0, m_bottom, kBottom);
  sphere(m_bottom, m_top, kTop);

  const Vec3 q = p - middle;
  const double from = t_min * speed - shift;
  if (!may_meet_waist(q, d, from)) return;
  const double qq = dot(q, q), tube2 = m_waist * m_waist, spindle2 = m_spindle * m_spindle;
  const double size = m_bottom + m_top + std::fabs(m_height);
  const double reach = size * size - qq;
  if (!(reach > 0.0)) return;
  double hi = std::sqrt(reach) * (1.0 + kWider), lo = -hi;
  lo = std::max(lo, from);
  // Only what lies between the spheres' shares counts.
  const double margin = kWider * size, low = m_low - margin - p.y, high = m_high + margin - p.y;
  if (d.y != 0.0) {
    lo = std::max(lo, std::min(low / d.y, high / d.y));
    hi = std::min(hi, std::max(low / d.y, high / d.y));
  } else if (low > 0.0 || high < 0.0) {
    return;
  }
  // t_max does not cut: the roots' last bits would depend on what else the ray has hit.
  if (!(lo < hi) || t_max * speed - shift <= lo) return;
  const double k = qq - spindle2 - tube2;
  const double quartic[5] = {1.0, 0.0, 2.0 * (k + 2.0 * spindle2 * d.y * d.y),
                             8.0 * spindle2 * q.y * d.y,
                             k * k + 4.0 * spindle2 * (q.y * q.y - tube2)};
  double root[4];
  const int n = solve_between(quartic, 4, lo, hi, root);
  for (int i = 0; i < n; ++i) {
    const Vec3 at = q + d * root[i];
    // The other half of the roots lies on the outer part of the torus.
    if (dot(at, at) + spindle2 <= tube2 * (1.0 + kWider)) report(root[i], kWaist);
  }
}

bool Ovus::nearest(const Ray& ray, double t_min, double t_max, ShapeHit& hit) const {
  return nearest_of_all(*this, ray, t_min, t_max, hit);
}

void Ovus::all(const Ray& ray, double t_min, double t_max, ShapeHits& hits) const {
  append_all(*this, ray, t_min, t_max, hits);
}

bool Ovus::within(const Vec3& p) const {
  const double across2 = p.x * p.x + p.z * p.z;
  if (p.y < m_low) return across2 + p.y * p.y <= m_bottom * m_bottom;
  if (p.y > m_high) return across2 + (p.y - m_bottom) * (p.y - m_bottom) <= m_top * m_top;
  const double out = std::sqrt(across2) + m_spindle, up = p.y - m_height;
  return out * out + up * up <= m_waist * m_waist;
}

Vec3 Ovus::normal(const Vec3& p, const ShapeHit& hit) const {
  if (hit.element == kBottom) return p;
  if (hit.element == kTop) return p - Vec3{0.0, m_bottom, 0.0};
  const double across = std::sqrt(p.x * p.x + p.z * p.z);
  if (!(across > 0.0)) return {0.0, p.y - m_height, 0.0};
  const double out = 1.0 + m_spindle / across;
  return {p.x * out, p.y - m_height, p.z * out};
}

Vec2 Ovus::uv(const Vec3& p, const ShapeHit&) const {
  const Vec3 q = p - Vec3{0.0, 0.5 * m_top, 0.0};
  const double far = length(q);
  if (far == 0.0) return {};
  return {turn_about_axis(q / far), 0.5 + std::asin(q.y / far) / std::numbers::pi};
}

}  // namespace lentray::core
