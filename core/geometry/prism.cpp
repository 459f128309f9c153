#include "core/geometry/prism.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/bounds_help.h"
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
      m_open(open) {}

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

bool Prism::contains(double u, double v, double height) const {
  if (m_sweep == Sweep::kConic) {
    if (height == 0.0) return false;
    u /= height;
    v /= height;
  }
  return m_outline->contains(u, v);
}

template <class Visit>
void Prism::walls(const Vec3& origin, const Vec3& direction, Visit&& visit) const {
  // Plane in which the ray and the direction of the sweep lie, as a line across the outline.
  Vec3 plane{direction.y, -direction.x, origin.y * direction.x - origin.x * direction.y};
  if (m_sweep == Sweep::kConic) plane = cross(origin, direction);
  if (plane.x == 0.0 && plane.y == 0.0) return;
  m_outline->crossings(plane.x, plane.y, plane.z, [&](std::uint32_t piece, double s) {
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

template <class Visit>
void Prism::crossings(const Ray& ray, Visit&& visit) const {
  const Vec3 origin = swept(ray.origin), direction = swept(ray.direction);
  if (!m_open && direction.z != 0.0) {
    const double heights[2] = {m_from, m_to};
    for (const std::uint32_t cap : {kLowCap, kHighCap}) {
      const double t = (heights[cap] - origin.z) / direction.z;
      if (contains(origin.x + t * direction.x, origin.y + t * direction.y, heights[cap])) {
        visit(t, cap, 0.0);
      }
    }
  }
  walls(origin, direction, visit);
}

bool Prism::nearest(const Ray& ray, double t_min, double t_max, ShapeHit& hit) const {
  const auto each = [&](auto&& visit) { crossings(ray, visit); };
  return nearest_of_all(each, t_min, t_max, hit);
}

void Prism::all(const Ray& ray, double t_min, double t_max, ShapeHits& hits) const {
  const auto each = [&](auto&& visit) { crossings(ray, visit); };
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
