#include "core/shape/box.h"

namespace lentray::core {

Box::Box(const Vec3& corner1, const Vec3& corner2) {
  Bounds b;
  b.include(corner1);
  b.include(corner2);
  m_lo = b.lo;
  m_hi = b.hi;
}

/// Where the ray's line enters and leaves; 0 if it misses. Written without branches on the
/// direction's signs. Where sides are hit together the lower axis gives the normal.
int Box::crossings(const Ray& ray, double, double, bool, Crossing* out) const {
  double near[3], far[3], enter = -Bounds::kInf, leave = Bounds::kInf;
  for (int i = 0; i < 3; ++i) {
    const double o = ray.origin[i], d = ray.direction[i];
    if (d == 0.0) {
      if (o < m_lo[i] || o > m_hi[i]) return 0;
      near[i] = -Bounds::kInf;
      far[i] = Bounds::kInf;
      continue;
    }
    const double lower = (m_lo[i] - o) / d, upper = (m_hi[i] - o) / d;
    near[i] = std::min(lower, upper);
    far[i] = std::max(lower, upper);
    enter = std::max(enter, near[i]);
    leave = std::min(leave, far[i]);
    if (!(enter <= leave)) return 0;
  }
  const int first = enter == near[0] ? 0 : enter == near[1] ? 1 : 2;
  const int last = leave == far[0] ? 0 : leave == far[1] ? 1 : 2;
  const int in = 2 * first + (ray.direction[first] > 0.0 ? 0 : 1);
  const int out_of = 2 * last + (ray.direction[last] > 0.0 ? 1 : 0);
  out[0] = {enter, static_cast<std::uint32_t>(in)};
  out[1] = {leave, static_cast<std::uint32_t>(out_of)};
  return 2;
}

Vec3 Box::normal(const Vec3&, const ShapeHit& hit) const {
  Vec3 n;
  n[static_cast<int>(hit.element / 2)] = hit.element & 1u ? 1.0 : -1.0;
  return n;
}

Vec2 Box::uv(const Vec3& p, const ShapeHit& hit) const {
  const Vec3 size = m_hi - m_lo;
  const Vec3 q{(p.x - m_lo.x) / size.x, (p.y - m_lo.y) / size.y, (p.z - m_lo.z) / size.z};
  // The sides lie in a cross, four wide and three high (manual, "UV Mapping", box).
  switch (hit.element) {
    case 0: return {q.z / 4.0, 1.0 / 3.0 + q.y / 3.0};
    case 1: return {3.0 / 4.0 - q.z / 4.0, 1.0 / 3.0 + q.y / 3.0};
    case 2: return {1.0 / 4.0 + q.x / 4.0, q.z / 3.0};
    case 3: return {1.0 / 4.0 + q.x / 4.0, 1.0 - q.z / 3.0};
    case 4: return {1.0 - q.x / 4.0, 1.0 / 3.0 + q.y / 3.0};
    default: return {1.0 / 4.0 + q.x / 4.0, 1.0 / 3.0 + q.y / 3.0};
  }
}

std::unique_ptr<Shape> Box::baked(const Transform& t) const {
  for (int i = 0; i < 3; ++i) {
    Vec3 e;
    e[i] = 1.0;
    Vec3 image = t.vector(e);
    if (!(image[i] > 0.0)) return nullptr;  // mirrored sides would change places
    image[i] = 0.0;
    if (!(image == Vec3{})) return nullptr;
  }
  return std::make_unique<Box>(t.point(m_lo), t.point(m_hi));
}

}  // namespace lentray::core
