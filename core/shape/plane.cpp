#include "core/shape/plane.h"

namespace lentray::core {
namespace {
constexpr double kOnSurface = 1e-10;  // how far from the plane a point still lies on it
}

Plane::Plane(const Vec3& normal, double distance)
    : m_normal(normalized(normal)), m_distance(distance) {}

Bounds Plane::own_box() const {
  Bounds b = Bounds::everything();
  for (int i = 0; i < 3; ++i) {
    if (m_normal[i] == 1.0) b.hi[i] = m_distance + kOnSurface + 1e-15 * std::fabs(m_distance);
    if (m_normal[i] == -1.0) b.lo[i] = -m_distance - kOnSurface - 1e-15 * std::fabs(m_distance);
  }
  return b;
}

bool Plane::nearest(const Ray& ray, double t_min, double t_max, ShapeHit& hit) const {
  const double t = plane_crossing(m_normal, m_distance, ray);
  if (!(t > t_min && t < t_max)) return false;
  hit = {t, 0, 0.0, 0.0};
  return true;
}

bool Plane::holds(const Vec3& p, bool inverse) const {
  const double above = dot(m_normal, p) - m_distance;
  return (inverse ? -above : above) < kOnSurface;
}
Vec3 Plane::normal(const Vec3&, const ShapeHit&) const { return m_normal; }

std::unique_ptr<Shape> Plane::baked(const Transform& t) const {
  const Vec3 n = normalized(t.normal(m_normal));
  return std::make_unique<Plane>(n, dot(n, t.point(m_normal * m_distance)));
}

}  // namespace lentray::core
