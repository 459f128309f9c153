// How a surface answers light. Linear colours; cosines of angles.
// Source: reference manual 3.7, "Finish"; defaults are those of `#version 3.7`.
#pragma once

#include <optional>

#include "core/base/color.h"

namespace lentray::core {

/// Light that enters a solid, is scattered in it, and leaves it elsewhere.
struct SubsurfaceFinish {
  Rgb translucency;              ///< mm that light goes between two scatterings; positive
  double diffuse, diffuse_back;  ///< as written: the colour, as without subsurface light
};

struct Finish {
  Rgb ambient{0.1f, 0.1f, 0.1f};
  Rgb emission;
  double diffuse = 0.6, diffuse_back = 0.0;  ///< `diffuse f, b`
  double albedo_factor = 1.0;                ///< in both of them; indirect light goes without it
  double brilliance = 1.0;
  double phong = 0.0, phong_size = 40.0;
  double specular = 0.0, roughness_exponent = 20.0;  ///< exponent is 1 / roughness
  double metallic = 0.0;
  Rgb reflection_min, reflection_max;
  double reflection_falloff = 1.0, reflection_metallic = 0.0;
  double reflection_exponent = 1.0;  ///< as written: reflected light is raised to 1 / exponent
  bool reflection_fresnel = false;
  bool reflection_variable = false;  ///< reflection {} block was used: min and max vary by angle
  bool conserve_energy = false;
  double crand = 0.0;
  double irid = 0.0, irid_thickness = 0.0, irid_turbulence = 0.0;  ///< thin film interference
  /// In place of the diffuse light of light sources: both values of `diffuse` are 0 then.
  std::optional<SubsurfaceFinish> subsurface;
};

}  // namespace lentray::core
