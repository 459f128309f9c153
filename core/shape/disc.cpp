#include "core/shape/disc.h"

#include <cmath>

#include "core/numeric/bounds_help.h"

namespace lentray::core {

Disc::Disc(const Vec3& centre, const Vec3& normal, double radius, double hole)
    : m_centre(centre), m_normal(normalized(normal)), m_radius(std::fabs(radius)),
      m_hole(std::fabs(hole)) {}

Bounds Disc::box(const Transform* move) const {
  return padded(circle_bounds(m_centre, m_normal, m_radius, move ? *move : Transform()));
}

bool Disc::nearest(const Ray& ray, double t_min, double t_max, ShapeHit& hit) const {
  const double slope = dot(m_normal, ray.direction);
  if (slope == 0.0) return false;
  const double t = dot(m_normal, m_centre - ray.origin) / slope;
  if (!(t > t_min && t < t_max)) return false;
  const double r2 = length_squared(ray.at(t) - m_centre);
  if (!(r2 >= m_hole * m_hole && r2 <= m_radius * m_radius)) return false;
  hit = {t, 0, 0.0, 0.0};
  return true;
}

bool Disc::holds(const Vec3& p, bool inverse) const {
  return (dot(m_normal, p - m_centre) < 0.0) != inverse;
}
Vec3 Disc::normal(const Vec3&, const ShapeHit&) const { return m_normal; }

std::unique_ptr<Shape> Disc::baked(const Transform& t) const {
  const double scale = similarity_scale(t);
  if (scale == 0.0) return nullptr;
  return std::make_unique<Disc>(t.point(m_centre), t.normal(m_normal), m_radius * scale,
                                m_hole * scale);
}

}  // namespace lentray::core
