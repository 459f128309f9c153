// Which photons are to be shot: a unit is a light and a target, at which photons are sent in rings about the
// way from the light to the middle of the target. World space. Pure functions.
// Source: reference manual 3.7, "Photons"; sizes and order are those that replay stock's files of photons
// (tests/image/photon_file_test.cpp).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/ray.h"
#include "core/light/light.h"
#include "core/photon/settings.h"
#include "core/photon/target.h"

namespace lentray::core {

struct PhotonUnit {
  std::uint32_t light, target;  ///< their indices
  /// Of photons from each other: lengths if the light is parallel, else lengths a unit of way.
  double spread;
  double step;  ///< from ring to ring: a length if the light is parallel, else radians
  double end;   ///< the same, where rings end
};

/// Light by light, target by target. Lights without shadow and those of light groups shoot none.
/// `spacing` is photon_spacing().
std::vector<PhotonUnit> photon_units(std::span<const Light> lights,
                                     std::span<const PhotonTarget> targets, double spacing);

/// Between photons on a target of factor 1: what the settings say, or what their count makes of it.
double photon_spacing(std::span<const Light> lights, std::span<const PhotonTarget> targets,
                      const PhotonSettings& settings);

/// How many photons leave the light at once, one a point of its area.
inline int photons_at_once(const Light& light) {
  const bool by_area = light.has_area && light.photon_area && !light.parallel;
  return by_area ? light.area.size1 * light.area.size2 : 1;
}

/// About how many photons will be shot.
double expected_photons(std::span<const Light> lights, std::span<const PhotonUnit> units);

/// The axes of rings about the way from a point to a target's middle; `left` is across it.
struct PhotonAim {
  Vec3 along, left;
};
PhotonAim photon_aim(const Light& light, const Vec3& from, const Vec3& centre);

/// The ray of a photon that leaves the point `from` of a light. `out`: how far from the axis, as
/// PhotonUnit::step; `turn`: about the axis, radians. The direction is unit.
Ray photon_ray(const Light& light, const Vec3& from, const Vec3& centre, double out, double turn);

}  // namespace lentray::core
