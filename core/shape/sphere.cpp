#include "core/shape/sphere.h"

#include <numbers>

#include "core/numeric/bounds_help.h"

namespace lentray::core {

Sphere::Sphere(const Vec3& centre, double radius)
    : m_centre(centre), m_radius(std::fabs(radius)), m_radius2(radius * radius) {}

Bounds Sphere::own_box() const {
  return padded({m_centre - Vec3(m_radius), m_centre + Vec3(m_radius)});
}

Bounds Sphere::box_in(const Transform& t) const {
  const Vec3 c = t.point(m_centre);
  const Vec3 e = ellipsoid_extent(t.vector({m_radius, 0, 0}), t.vector({0, m_radius, 0}),
                                  t.vector({0, 0, m_radius}));
  return padded({c - e, c + e});
}

bool Sphere::nearest(const Ray& ray, double t_min, double t_max, ShapeHit& hit) const {
  double t0, t1;
  const double inverse_dd = 1.0 / dot(ray.direction, ray.direction);
  if (!sphere_roots(ray, inverse_dd, m_centre, m_radius2, t0, t1)) return false;
  const double t = t0 > t_min ? t0 : t1;
  if (!(t > t_min && t < t_max)) return false;
  hit = {t, 0, 0.0, 0.0};
  return true;
}

bool Sphere::any(const Ray& ray, double t_min, double t_max) const {
  ShapeHit hit;
  return Sphere::nearest(ray, t_min, t_max, hit);
}

void Sphere::all(const Ray& ray, double t_min, double t_max, ShapeHits& hits) const {
  double t0, t1;
  const double inverse_dd = 1.0 / dot(ray.direction, ray.direction);
  if (!sphere_roots(ray, inverse_dd, m_centre, m_radius2, t0, t1)) return;
  if (t0 > t_min && t0 < t_max) hits.push_back({t0, 0, 0.0, 0.0});
  if (t1 > t_min && t1 < t_max && t1 != t0) hits.push_back({t1, 0, 0.0, 0.0});
}

bool Sphere::holds(const Vec3& p, bool inverse) const {
  const double far2 = length_squared(p - m_centre);
  return inverse ? far2 > m_radius2 : far2 < m_radius2;
}
Vec3 Sphere::normal(const Vec3& p, const ShapeHit&) const { return p - m_centre; }

Vec2 Sphere::uv(const Vec3& p, const ShapeHit&) const {
  Vec3 q = p - m_centre;
  if (m_turn) q = m_turn->inverse_vector(q);
  q = normalized(q);
  const double around = std::hypot(q.x, q.z);
  double theta = 0.0;
  if (q.x * q.x + q.z * q.z > 1e-10) {
    theta = std::acos(std::clamp(q.x / around, -1.0, 1.0));
    if (q.z < 0.0) theta = 2.0 * std::numbers::pi - theta;
  }
  return {theta / (2.0 * std::numbers::pi),
          0.5 + std::asin(std::clamp(q.y, -1.0, 1.0)) / std::numbers::pi};
}

std::unique_ptr<Shape> Sphere::baked(const Transform& t) const {
  const double scale = similarity_scale(t);
  if (scale == 0.0) return nullptr;
  auto sphere = std::make_unique<Sphere>(t.point(m_centre), m_radius * scale);
  const bool only_scaled = t.vector({1, 0, 0}) == Vec3{scale, 0, 0} &&
                           t.vector({0, 1, 0}) == Vec3{0, scale, 0} &&
                           t.vector({0, 0, 1}) == Vec3{0, 0, scale};
  if (!only_scaled) {
    sphere->m_turn = std::make_unique<const Transform>(m_turn ? m_turn->then(t) : t);
  } else if (m_turn) {
    sphere->m_turn = std::make_unique<const Transform>(*m_turn);
  }
  return sphere;
}

}  // namespace lentray::core
