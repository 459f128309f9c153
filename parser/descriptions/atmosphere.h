// Fog, rainbow, sky_sphere, background: what surrounds a scene.
// Source: reference manual 3.7, "Atmospheric Effects".
#pragma once

#include <optional>
#include <vector>

#include "core/base/color.h"
#include "core/base/transform.h"
#include "core/base/vec3.h"
#include "parser/source/source.h"
#include "parser/values/value.h"

namespace lentray::parser {

struct FogDesc {
  Location where;
  int type = 1;  ///< 1 constant, 2 ground
  double distance = 0.0;
  core::Colour colour;
  double turb_depth = 0.5;
  std::optional<core::Vec3> turbulence;  ///< octaves, lambda and omega set it, too; 0 stirs as well
  int octaves = 6;
  double lambda = 2.0, omega = 0.5;
  double fog_offset = 0.0, fog_alt = 0.0;
  core::Vec3 up{0.0, 1.0, 0.0};
  core::Transform transform;
};

struct RainbowDesc {
  Location where;
  core::Vec3 direction, up{0.0, 1.0, 0.0};
  double angle = 0.0, width = 0.0, distance = 1e7, jitter = 0.0;  ///< angles in degrees
  double arc_angle = 360.0;
  std::optional<double> falloff_angle;  ///< unset: the arc does not fade
  Ref<ColourMapDesc> colour_map;
};

struct SkySphereDesc {
  Location where;
  std::vector<Ref<PigmentDesc>> pigments;  ///< later ones lie on top
  core::Transform transform;
  core::Rgb emission{1.0f, 1.0f, 1.0f};
};

}  // namespace lentray::parser
