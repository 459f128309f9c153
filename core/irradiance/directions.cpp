#include "core/irradiance/directions.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/numeric/radical_inverse.h"

namespace lentray::core {
namespace {

/// Normals are different where a component differs by more.
constexpr double kSameNormal = 1e-6;

bool is_same(const Vec3& a, const Vec3& b) {
  return std::fabs(a.x - b.x) < kSameNormal && std::fabs(a.y - b.y) < kSameNormal &&
         std::fabs(a.z - b.z) < kSameNormal;
}

}  // namespace

std::vector<Vec3> cosine_weighted_directions(std::size_t count) {
  std::vector<Vec3> directions;
  directions.reserve(count);
  for (std::size_t i = 1; i <= count; ++i) {
    const double radius = std::sqrt(radical_inverse(i, 2));
    const double angle = 2.0 * std::numbers::pi * radical_inverse(i, 3);
    const double x = radius * std::cos(angle), z = radius * std::sin(angle);
    directions.emplace_back(x, std::sqrt(1.0 - x * x - z * z), z);
  }
  return directions;
}

Hemisphere::Hemisphere(const Vec3& normal) : m_normal(normal) {
  constexpr double kAlongAxis = 0.9;
  const Vec3 aside = std::fabs(normal.z) > kAlongAxis ? Vec3(0.0, 1.0, 0.0) : Vec3(0.0, 0.0, 1.0);
  m_x = normalized(cross(normal, aside));
  m_z = normalized(cross(m_x, normal));
}

Vec3 Hemisphere::turned(const Vec3& direction) const {
  constexpr double kUpright = 0.999;
  if (std::fabs(m_normal.y) > kUpright) return m_normal.y > 0.0 ? direction : -direction;
  return m_x * direction.x + m_normal * direction.y + m_z * direction.z;
}

GatherDirections::GatherDirections(DirectionCycle& cycle, const Vec3& surface_normal,
                                   const Vec3& normal, unsigned rays)
    : m_cycle(cycle), m_surface_normal(surface_normal),
      m_about_surface(is_same(surface_normal, normal)),
      m_hemisphere(m_about_surface ? surface_normal : normal) {
  constexpr std::size_t kTries = 5;  ///< for each ray, about a perturbed normal
  const std::size_t all = cycle.length();
  m_left = m_about_surface ? all : std::min(all, kTries * std::min<std::size_t>(all, rays));
}

bool GatherDirections::next(Vec3& direction) {
  for (;;) {
    if (m_left == 0) {
      if (m_about_surface || m_cycle.length() == 0) return false;
      m_about_surface = true;
      m_hemisphere = Hemisphere(m_surface_normal);
      m_left = m_cycle.length();
    }
    --m_left;
    direction = m_hemisphere.turned(m_cycle.next());
    if (m_about_surface || dot(direction, m_surface_normal) > 0.0) return true;
  }
}

}  // namespace lentray::core
