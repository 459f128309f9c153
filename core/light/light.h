// A light source, compiled. World space. Source: reference manual 3.7, "Light Source".
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/color.h"
#include "core/base/vec3.h"

namespace lentray::core {

class Object;

struct AreaLight {
  Vec3 axis1, axis2;
  int size1 = 1, size2 = 1;
  int adaptive = -1;  ///< -1: every sample is tested
  bool jitter = false, circular = false, orient = false;
  bool area_illumination = false;  ///< every point of the grid illuminates, not the position alone
};

struct Light {
  enum class Kind { kPoint, kSpot, kCylinder };
  Kind kind = Kind::kPoint;
  Vec3 position;
  Rgb colour;
  Vec3 point_at{0.0, 0.0, 1.0};
  Vec3 direction;  ///< unit, from position to point_at (spot, cylinder, parallel)
  bool parallel = false;
  double radius = 0.0, falloff = 0.0;  ///< spot: cosines of the angles; cylinder: scene units
  double tightness = 0.0;
  bool has_area = false;
  AreaLight area;
  double fade_distance = 0.0, fade_power = 0.0;
  bool shadowless = false;  ///< fill light: no shadows and no highlights
  /// Only what goes through it is light, and only what lies before it throws a shadow; null: none.
  const Object* projector = nullptr;
  bool lights_media = true;    ///< media_interaction
  bool dimmed_by_air = false;  ///< media_attenuation: fog and media of the air dim it
  bool grouped = false;        ///< of a light_group: lights only what selects it
  std::optional<bool> photon_reflection, photon_refraction;  ///< empty: not said
  bool photon_area = false;  ///< photons come from all points of an area light

  bool illuminates_by_area() const { return has_area && area.area_illumination; }
};

/// What lights an object of a light_group. Source: reference manual 3.7, "Light Groups".
struct LightSelection {
  bool global = false;               ///< the lights outside all groups, before the group's
  std::vector<std::uint32_t> local;  ///< indices of grouped lights, in the order they count
};

}  // namespace lentray::core
