#include "core/geometry/prism.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/bounds_help.h"
#include "core/geometry/box_ray.h"
#include "core/geometry/crossings.h"

namespace lentray::core {
namespace {

// Elements of a hit: the caps, then the pieces of the outline.
constexpr std::uint32_t kLowCap = 0, kHighCap = 1, kFirstWall = 2;

}  // namespace

Prism::Prism(std::string_view name, std::shared_ptr<const Outline> outline, Sweep sweep,
             double from, double to, bool open)
    : m_name(name),
      m_outline(std::move(outline)),
      m_sweep(sweep),
      m_from(std::min(from, to)),
      m_to(std::max(from, to)),
      m_open(open),
      m_reach(widened(Prism::bounds())) {}

Bounds Prism::bounds() const {
  if (m_outline->pieces().empty()) return {};
  const Vec2 lo = m_outline->lo(), hi = m_outline->hi();
  Bounds box;
  for (const double height : {m_from, m_to}) {
    const double scale = m_sweep == Sweep::kConic ? height : 1.0;
    box.include(swept({lo.u * scale, lo.v * scale, height}));
    box.include(swept({hi.u * scale, hi.v * scale, height}));
  }
  return padded(box);
}

Bounds Prism::bounds_in(const Transform& t) const {
  if (keeps_axes(t) || m_outline->pieces().empty()) return Shape::bounds_in(t);
  return support_bounds(t, [&](const Vec3& direction) {
    const Vec3 d = swept(direction);
    const auto outline = [&](double u, double v) {
      double far = -Bounds::kInf;
      for (const CurvePiece& piece : m_outline->pieces()) far = std::max(far, piece.farthest({u, v}));
      return far;
    };
    if (m_sweep != Sweep::kConic) return outline(d.x, d.y) + std::max(d.z * m_from, d.z * m_to);
    return std::max(outline(d.x * m_from, d.y * m_from) + d.z * m_from,
                    outline(d.x * m_to, d.y * m_to) + d.z * m_to);
  });
}

void Prism::drop_shortcuts() {
  auto outline = std::make_shared<Outline>(*m_outline);
  outline->drop_boxes();
  m_outline = std::move(outline);
  m_reach = Bounds::everything();
}

bool Prism::contains(double u, double v, double height) const {
  if (m_sweep == Sweep::kConic) {
    if (height == 0.0) return false;
    u /= height;
    v /= height;
  }
  return m_outline->contains(u, v);
}

/// Where over the outline the ray lies between the caps and between t_min and t_max: a box, a
/// little wider.
Outline::Box Prism::shadow(const Vec3& origin, const Vec3& direction, double t_min, double t_max) const {
  constexpr double kInf = Bounds::kInf, kSlack = 1e-9;
  const Outline::Box everywhere{{-kInf, -kInf}, {kInf, kInf}};
  if (direction.z != 0.0) {
    const double a = (m_from - origin.z) / direction.z, b = (m_to - origin.z) / direction.z;
    t_min = std::max(t_min, std::min(a, b));
    t_max = std::min(t_max, std::max(a, b));
  }
  const Vec3 first = origin + direction * t_min, last = origin + direction * t_max;
  if (!is_finite(first) || !is_finite(last)) return everywhere;
  double u1 = first.x, v1 = first.y, u2 = last.x, v2 = last.y;
  if (m_sweep == Sweep::kConic) {
    // Towards the tip it has no end.
    constexpr double kTip = 1e-3;
    if (!(first.z * last.z > 0.0) || std::min(std::fabs(first.z), std::fabs(last.z)) < kTip) return everywhere;
    u1 /= first.z;
    v1 /= first.z;
    u2 /= last.z;
    v2 /= last.z;
  }
  const double size = std::fabs(origin.x) + std::fabs(origin.y) + std::fabs(u1) + std::fabs(v1) +
                      std::fabs(u2) + std::fabs(v2) + std::fabs(origin.z) + std::fabs(m_from) + std::fabs(m_to);
  const double by = kSlack * size * (m_sweep == Sweep::kConic ? 1e3 : 1.0);
  return {{std::min(u1, u2) - by, std::min(v1, v2) - by}, {std::max(u1, u2) + by, std::max(v1, v2) + by}};
}

template <class Visit>
void Prism::walls(const Vec3& origin, const Vec3& direction, double t_min, double t_max, Visit&& visit) const {
  // Plane in which the ray and the direction of the sweep lie, as a line across the outline.
  Vec3 plane{direction.y, -direction.x, origin.y * direction.x - origin.x * direction.y};
  if (m_sweep == Sweep::kConic) plane = cross(origin, direction);
  if (plane.x == 0.0 && plane.y == 0.0) return;
  const Outline::Box region = shadow(origin, direction, t_min, t_max);
  m_outline->crossings(plane.x, plane.y, plane.z, region, [&](std::uint32_t piece, double s) {
    const Vec2 p = m_outline->pieces()[piece].at(s);
    double du = direction.x, dv = direction.y, u = p.u - origin.x, v = p.v - origin.y;
    if (m_sweep == Sweep::kConic) {
      du -= direction.z * p.u;
      dv -= direction.z * p.v;
      u = origin.z * p.u - origin.x;
      v = origin.z * p.v - origin.y;
    }
    const double t = std::fabs(du) > std::fabs(dv) ? u / du : v / dv;
    const double height = origin.z + t * direction.z;
    if (height >= m_from && height <= m_to) visit(t, kFirstWall + piece, s);
  });
}

/// Where the line of the ray meets a cap.
bool Prism::met_cap(std::uint32_t cap, const Vec3& origin, const Vec3& direction, double& t) const {
  if (m_open || direction.z == 0.0) return false;
  const double height = cap == kLowCap ? m_from : m_to;
  t = (height - origin.z) / direction.z;
  return contains(origin.x + t * direction.x, origin.y + t * direction.y, height);
}

template <class Visit>
void Prism::crossings(const Ray& ray, double t_min, double t_max, Visit&& visit) const {
  if (!BoxRay(ray).meets(m_reach, t_min, t_max)) return;
  const Vec3 origin = swept(ray.origin), direction = swept(ray.direction);
  for (const std::uint32_t cap : {kLowCap, kHighCap}) {
    double t;
    if (met_cap(cap, origin, direction, t)) visit(t, cap, 0.0);
  }
  walls(origin, direction, t_min, t_max, visit);
}

/// The cap that the ray comes to first is before all else: walls lie between the caps.
bool Prism::nearest(const Ray& ray, double t_min, double t_max, ShapeHit& hit) const {
  if (!BoxRay(ray).meets(m_reach, t_min, t_max)) return false;
  const Vec3 origin = swept(ray.origin), direction = swept(ray.direction);
  const std::uint32_t first = direction.z > 0.0 ? kLowCap : kHighCap;
  double t;
  if (met_cap(first, origin, direction, t) && t > t_min && t < t_max) {
    hit = {t, first, 0.0, 0.0};
    return true;
  }
  const auto each = [&](auto&& visit) { crossings(ray, t_min, t_max, visit); };
  return nearest_of_all(each, t_min, t_max, hit);
}

void Prism::all(const Ray& ray, double t_min, double t_max, ShapeHits& hits) const {
  const auto each = [&](auto&& visit) { crossings(ray, t_min, t_max, visit); };
  append_all(each, t_min, t_max, hits);
}

bool Prism::inside(const Vec3& p) const {
  const Vec3 at = swept(p);
  return at.z >= m_from && at.z <= m_to && contains(at.x, at.y, at.z);
}

Vec3 Prism::normal(const Vec3& p, const ShapeHit& hit) const {
  if (hit.element == kLowCap) return m_sweep == Sweep::kAlongZ ? Vec3{0, 0, -1} : Vec3{0, 1, 0};
  if (hit.element == kHighCap) return m_sweep == Sweep::kAlongZ ? Vec3{0, 0, 1} : Vec3{0, 1, 0};
  const Vec2 slope = m_outline->pieces()[hit.element - kFirstWall].slope(hit.u);
  Vec3 n{slope.v, -slope.u, 0.0};
  if (m_sweep == Sweep::kConic && p.y != 0.0) n.z = -(p.x * n.x + p.z * n.y) / p.y;
  return swept(n);
}

}  // namespace lentray::core
