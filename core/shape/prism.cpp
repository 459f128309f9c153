#include "core/shape/prism.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/numeric/bounds_help.h"
#include "core/numeric/box_ray.h"

namespace lentray::core {
namespace {

// Elements of a hit: the caps, then the pieces of the outline.
constexpr std::uint32_t kLowCap = 0, kHighCap = 1, kFirstWall = 2;

}  // namespace

Prism::Prism(std::string_view name, std::shared_ptr<const Outline> outline, Sweep sweep,
             double from, double to, bool open)
    : m_name(name), m_outline(std::move(outline)), m_sweep(sweep), m_from(std::min(from, to)),
      m_to(std::max(from, to)), m_farther(std::fabs(from) + std::fabs(to)), m_open(open),
      m_convex(!open && sweep != Sweep::kConic && m_outline->is_convex()),
      m_reach(widened(own_box())) {}

Bounds Prism::own_box() const {
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

Bounds Prism::box_in(const Transform& t) const {
  if (keeps_axes(t) || m_outline->pieces().empty()) return transformed(own_box(), t);
  return support_bounds(t, [&](const Vec3& direction) {
    const Vec3 d = swept(direction);
    const auto outline = [&](double u, double v) { return m_outline->farthest({u, v}); };
    if (m_sweep != Sweep::kConic) return outline(d.x, d.y) + std::max(d.z * m_from, d.z * m_to);
    return std::max(outline(d.x * m_from, d.y * m_from) + d.z * m_from,
                    outline(d.x * m_to, d.y * m_to) + d.z * m_to);
  });
}

/// False at the tip.
bool Prism::on_outline(double& u, double& v, double height) const {
  if (m_sweep != Sweep::kConic) return true;
  if (height == 0.0) return false;
  u /= height;
  v /= height;
  return true;
}

bool Prism::contains(double u, double v, double height) const {
  return on_outline(u, v, height) && m_outline->contains(u, v);
}

/// False if the ray meets nothing for sure.
[[gnu::always_inline]] inline bool Prism::passes(const Ray& ray, const Vec3& origin,
                                                 const Vec3& direction, double t_min, double t_max,
                                                 Passage& passage) const {
  constexpr double kSlack = 1e-9;
  double from = t_min, to = t_max;
  if (direction.z != 0.0) {
    // Where all of it lies behind t_min, that is known without a division.
    constexpr double kSure = 1e-6;
    const double low = m_from - origin.z, high = m_to - origin.z, least = t_min * direction.z;
    const double sure = kSure * (std::fabs(low) + std::fabs(high) + std::fabs(least));
    if (direction.z > 0.0 ? high + sure < least : low - sure > least) return false;
    const double a = low / direction.z, b = high / direction.z;
    passage.caps[kLowCap] = a;
    passage.caps[kHighCap] = b;
    const double slack = kSlack * (std::fabs(a) + std::fabs(b));
    const double enters = std::min(a, b), leaves = std::max(a, b);
    if (!(enters - slack <= t_max && leaves + slack >= t_min)) return false;
    from = std::max(t_min, enters);
    to = std::min(t_max, leaves);
  } else {
    if (!(origin.z >= m_from && origin.z <= m_to)) return false;
    passage.caps[kLowCap] = passage.caps[kHighCap] = std::numeric_limits<double>::quiet_NaN();
  }
  const auto by_bounds = [&] { return BoxRay(ray).meets(m_reach, t_min, t_max); };
  const Vec3 first = origin + direction * from, last = origin + direction * to;
  Vec2 begin{first.x, first.y}, end{last.x, last.y};
  if (m_sweep == Sweep::kConic) {
    // Towards the tip it has no end.
    constexpr double kTip = 1e-3;
    if (!(first.z * last.z > 0.0) || std::min(std::fabs(first.z), std::fabs(last.z)) < kTip)
      return by_bounds();
    begin = {begin.u / first.z, begin.v / first.z};
    end = {end.u / last.z, end.v / last.z};
  }
  const double size = std::fabs(origin.x) + std::fabs(origin.y) + std::fabs(begin.u) +
                      std::fabs(begin.v) + std::fabs(end.u) + std::fabs(end.v) +
                      std::fabs(origin.z) + m_farther;
  if (!std::isfinite(size)) return by_bounds();
  const double by = kSlack * size * (m_sweep == Sweep::kConic ? 1e3 : 1.0);
  passage.way = {begin, end, by, true};
  const Vec2 &lo = m_outline->lo(), &hi = m_outline->hi();
  return std::min(begin.u, end.u) - by <= hi.u && std::max(begin.u, end.u) + by >= lo.u &&
         std::min(begin.v, end.v) - by <= hi.v && std::max(begin.v, end.v) + by >= lo.v;
}

template <bool first, class Visit>
void Prism::walls(const Vec3& origin, const Vec3& direction, const Passage& passage,
                  Visit&& visit) const {
  // Plane in which the ray and the direction of the sweep lie, as a line across the outline.
  Vec3 plane{direction.y, -direction.x, origin.y * direction.x - origin.x * direction.y};
  if (m_sweep == Sweep::kConic) plane = cross(origin, direction);
  if (plane.x == 0.0 && plane.y == 0.0) return;
  const auto met = [&](std::uint32_t piece, double s, const Vec2& p) {
    double du = direction.x, dv = direction.y, u = p.u - origin.x, v = p.v - origin.y;
    if (m_sweep == Sweep::kConic) {
      du -= direction.z * p.u;
      dv -= direction.z * p.v;
      u = origin.z * p.u - origin.x;
      v = origin.z * p.v - origin.y;
    }
    const double t = std::fabs(du) > std::fabs(dv) ? u / du : v / dv;
    const double height = origin.z + t * direction.z;
    return !(height >= m_from && height <= m_to) ? !first : visit(t, kFirstWall + piece, s);
  };
  if (first && passage.way.is_known) {
    m_outline->first_crossings(plane.x, plane.y, plane.z, passage.way, met);
  } else {
    m_outline->crossings(
        plane.x, plane.y, plane.z, passage.way,
        [&](std::uint32_t piece, double s, const Vec2& p) { return met(piece, s, p) || first; });
  }
}

/// Whether the place where the ray's line meets a cap's plane is on the cap.
bool Prism::is_on_cap(std::uint32_t cap, const Vec3& origin, const Vec3& direction,
                      const Passage& passage) const {
  const double t = passage.caps[cap];
  return !m_open && contains(origin.x + t * direction.x, origin.y + t * direction.y,
                             cap == kLowCap ? m_from : m_to);
}

/// The cap that the ray comes to first is before all else: walls lie between the caps.
bool Prism::nearest(const Ray& ray, double t_min, double t_max, ShapeHit& hit) const {
  const Vec3 origin = swept(ray.origin), direction = swept(ray.direction);
  Passage passage;
  if (!passes(ray, origin, direction, t_min, t_max, passage)) return false;
  const std::uint32_t first = direction.z > 0.0 ? kLowCap : kHighCap;
  double t = passage.caps[first];
  if (t > t_min && t < t_max && is_on_cap(first, origin, direction, passage)) {
    hit = {t, first, 0.0, 0.0};
    return true;
  }
  bool found = false;
  double best = t_max;
  walls<true>(origin, direction, passage, [&](double at, std::uint32_t element, double place) {
    if (!(at > t_min && at < t_max)) return false;
    // Where two meet the one that was made first counts.
    if (at < best || (found && at == best && element < hit.element)) {
      hit = {at, element, place, 0.0};
      best = at;
      found = true;
    }
    return true;
  });
  const std::uint32_t last = first == kLowCap ? kHighCap : kLowCap;
  t = passage.caps[last];
  // Where they meet the cap counts.
  if (t > t_min && t < t_max && t <= best && is_on_cap(last, origin, direction, passage)) {
    hit = {t, last, 0.0, 0.0};
    found = true;
  }
  return found;
}

bool Prism::any(const Ray& ray, double t_min, double t_max) const {
  const Vec3 origin = swept(ray.origin), direction = swept(ray.direction);
  Passage passage;
  if (!passes(ray, origin, direction, t_min, t_max, passage)) return false;
  // What needs no counting first: a cap well within the outline, then walls.
  bool unsure[2] = {};
  for (const std::uint32_t cap : {kLowCap, kHighCap}) {
    const double t = passage.caps[cap];
    if (m_open || !(t > t_min && t < t_max)) continue;
    double u = origin.x + t * direction.x, v = origin.y + t * direction.y;
    if (!on_outline(u, v, cap == kLowCap ? m_from : m_to)) continue;
    const Outline::Place place = m_outline->place(u, v);
    if (place == Outline::Place::kInside) return true;
    unsure[cap] = place == Outline::Place::kUnsure;
  }
  bool found = false;
  walls<false>(origin, direction, passage, [&](double at, std::uint32_t, double) {
    return !(found = at > t_min && at < t_max);
  });
  return found || (unsure[kLowCap] && is_on_cap(kLowCap, origin, direction, passage)) ||
         (unsure[kHighCap] && is_on_cap(kHighCap, origin, direction, passage));
}

void Prism::all(const Ray& ray, double t_min, double t_max, ShapeHits& hits) const {
  const Vec3 origin = swept(ray.origin), direction = swept(ray.direction);
  Passage passage;
  if (!passes(ray, origin, direction, t_min, t_max, passage)) return;
  const auto add = [&](double t, std::uint32_t element, double place) {
    if (t > t_min && t < t_max) hits.push_back({t, element, place, 0.0});
    return true;
  };
  for (const std::uint32_t cap : {kLowCap, kHighCap}) {
    const double t = passage.caps[cap];
    if (t > t_min && t < t_max && is_on_cap(cap, origin, direction, passage)) add(t, cap, 0.0);
  }
  walls<false>(origin, direction, passage, add);
}

bool Prism::within(const Vec3& p) const {
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
