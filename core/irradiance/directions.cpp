#include "core/irradiance/directions.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/numeric/radical_inverse.h"

namespace lentray::core {
namespace {

/// As stock tells equal normals: a component differs by more.
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

GatherDirections::GatherDirections(DirectionCycle& cycle, const Vec3& surface_normal,
                                   const Vec3& normal, unsigned rays)
    : m_cycle(cycle), m_surface_normal(surface_normal), m_layer_normal(normal),
      m_rays(std::min<std::size_t>(rays, cycle.length())) {
  aim(is_same(surface_normal, normal));
}

void GatherDirections::aim(bool about_surface) {
  constexpr std::size_t kTries = 5;  ///< for each ray, about a perturbed normal
  constexpr double kAlongAxis = 0.9;
  m_about_surface = about_surface;
  m_left = about_surface ? m_cycle.length() : std::min(m_rays * kTries, m_cycle.length());
  m_y = about_surface ? m_surface_normal : m_layer_normal;
  const Vec3 aside = std::fabs(m_y.z) > kAlongAxis ? Vec3(0.0, 1.0, 0.0) : Vec3(0.0, 0.0, 1.0);
  m_x = normalized(cross(m_y, aside));
  m_z = normalized(cross(m_x, m_y));
}

Vec3 GatherDirections::turned(const Vec3& direction) const {
  constexpr double kUpright = 0.999;
  if (m_y.y > kUpright) return direction;
  if (m_y.y < -kUpright) return -direction;
  return m_x * direction.x + m_y * direction.y + m_z * direction.z;
}

bool GatherDirections::take(Vec3& direction) {
  while (m_left > 0) {
    --m_left;
    direction = turned(m_cycle.next());
    if (m_about_surface || dot(direction, m_surface_normal) > 0.0) return true;
  }
  return false;
}

bool GatherDirections::next(Vec3& direction) {
  if (take(direction)) return true;
  if (m_about_surface) return false;
  aim(true);
  return take(direction);
}

}  // namespace lentray::core
