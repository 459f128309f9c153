#include "core/photon/units.h"

#include <cmath>
#include <numbers>

#include "core/base/tiny.h"
#include "core/base/transform.h"

namespace lentray::core {
namespace {

bool shoots(const Light& light) { return !light.shadowless && !light.grouped; }

bool refracts(const Light& light, const PhotonTarget& target) {
  return photons_go_on(target.refraction, light.photon_refraction);
}
bool reflects(const Light& light, const PhotonTarget& target) {
  return photons_go_on(target.reflection, light.photon_reflection);
}

/// `see(light, target)` for each pair that has photons, by indices.
template <class See>
void each_pair(std::span<const Light> lights, std::span<const PhotonTarget> targets, See&& see) {
  for (std::uint32_t l = 0; l < lights.size(); ++l) {
    if (!shoots(lights[l])) continue;
    for (std::uint32_t t = 0; t < targets.size(); ++t) {
      if (refracts(lights[l], targets[t]) || reflects(lights[l], targets[t])) see(l, t);
    }
  }
}

/// Of the light's area.
double photon_points(const Light& light) {
  return light.has_area && light.photon_area ? light.area.size1 * light.area.size2 : 1;
}

/// How far out rings go: to the edge of the target's ball, or all around from inside of it.
double end_of_rings(const Light& light, const PhotonTarget& target) {
  if (light.parallel) return target.radius;
  const double distance = length(target.centre - light.position);
  return distance >= target.radius ? std::asin(target.radius / distance) : std::numbers::pi;
}

/// How many photons a target gets and leaves: half of those that are shot at it arrive. What both reflects
/// and refracts makes more of them, the more so if it collects them itself.
double guessed_photons(const Light& light, const PhotonTarget& target, double spacing) {
  const bool refracted = refracts(light, target);
  const double ways = refracted && reflects(light, target) ? 1.5 : 1.0;
  const double stays = refracted && target.collects ? ways : 0.5;
  const double across = target.radius / (target.factor * spacing);
  return across * across * std::numbers::pi * ways * stays;
}

PhotonUnit make_unit(std::span<const Light> lights, std::span<const PhotonTarget> targets,
                     std::uint32_t l, std::uint32_t t, double spacing) {
  const Light& light = lights[l];
  const PhotonTarget& target = targets[t];
  const double distance = length(target.centre - light.position);
  const double way = light.parallel ? 1.0 : distance < kTiny ? target.radius : distance;
  const double spread = target.factor * spacing / way * std::sqrt(photon_points(light));
  return {l, t, spread, light.parallel ? spread : std::atan(spread), end_of_rings(light, target)};
}

}  // namespace

std::vector<PhotonUnit> photon_units(std::span<const Light> lights,
                                     std::span<const PhotonTarget> targets, double spacing) {
  std::vector<PhotonUnit> units;
  each_pair(lights, targets, [&](std::uint32_t light, std::uint32_t target) {
    units.push_back(make_unit(lights, targets, light, target, spacing));
  });
  return units;
}

double photon_spacing(std::span<const Light> lights, std::span<const PhotonTarget> targets,
                      const PhotonSettings& settings) {
  if (settings.count <= 0) return settings.spacing;
  double wanted = 0.0;
  each_pair(lights, targets, [&](std::uint32_t l, std::uint32_t t) {
    wanted += guessed_photons(lights[l], targets[t], settings.spacing);
  });
  return settings.spacing * std::sqrt(wanted / settings.count);
}

double expected_photons(std::span<const Light> lights, std::span<const PhotonUnit> units) {
  double sum = 0.0;
  for (const PhotonUnit& unit : units) {
    const Light& light = lights[unit.light];
    const double area = light.parallel ? std::numbers::pi * unit.end * unit.end
                                       : 2.0 * std::numbers::pi * (1.0 - std::cos(unit.end));
    sum += area / (unit.step * unit.step) * photons_at_once(light);
  }
  return sum;
}

PhotonAim photon_aim(const Light& light, const Vec3& from, const Vec3& centre) {
  constexpr double kUpright = 0.9;
  const Vec3 to = centre - from;
  if (length(to) < kTiny && !light.parallel) return {{0, 0, 1}, {0, 1, 0}};
  const Vec3 along = normalized(to);
  const Vec3 up = std::fabs(along.z) >= kUpright ? Vec3(0, 1, 0) : Vec3(0, 0, 1);
  return {along, normalized(cross(light.parallel ? light.direction : along, up))};
}

Ray photon_ray(const Light& light, const Vec3& from, const Vec3& centre, double out, double turn) {
  const PhotonAim aim = photon_aim(light, from, centre);
  const Vec3& axis = light.parallel ? light.direction : aim.along;
  // The order of operations is fixed: rounding decides which of two photons of a plane the map parts first.
  const Transform turned = Transform::axis_rotation(axis, turn);
  if (!light.parallel) {
    return {from, turned.point(aim.left * -std::sin(out) + axis * std::cos(out))};
  }
  const Vec3 to = centre - from;
  const double before = dot(axis, normalized(to)) * length(to);
  return {centre - axis * before + turned.point(aim.left * out), axis};
}

}  // namespace lentray::core
