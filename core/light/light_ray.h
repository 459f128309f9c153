// The way from a point to a light, and how much of the light's colour goes that way before
// anything stands in it. World space. Pure functions of their arguments.
// Source: reference manual 3.7, "Light Source" (spotlights, cylinders, parallel, fading);
// signs and limits as measured on stock (tests/image/shading_lights_test.cpp).
#pragma once

#include <cmath>

#include "core/base/vec3.h"
#include "core/light/light.h"

namespace lentray::core {

struct LightRay {
  Vec3 direction;         ///< unit, towards the light
  double distance = 0.0;  ///< to the light, or to its plane; negative behind a parallel light
};

/// Whether a light's rays all go to its position.
inline bool is_straight(const Light& light) {
  return !light.parallel && light.kind != Light::Kind::kCylinder;
}
/// For lights of which that is not true.
LightRay directed_light_ray(const Light& light, const Vec3& from, const Vec3& offset);

inline LightRay ray_along(const Vec3& to) {
  const double distance = length(to);
  return {to * (1.0 / distance), distance};
}
/// Ray from `from` to the light's position moved by `offset` (a sample of an area light).
inline LightRay light_ray(const Light& light, const Vec3& from, const Vec3& offset = {}) {
  if (!is_straight(light)) return directed_light_ray(light, from, offset);
  return ray_along(light.position + offset - from);
}

/// Factor of the cone or the cylinder; 0 outside.
double beam_factor(const Light& light, const Vec3& from, const LightRay& ray);
/// The same and of fading.
double light_attenuation(const Light& light, const Vec3& from, const LightRay& ray);

/// Whether a light has one colour everywhere, for a loop over lights: one that illuminates by its area
/// has cones and fading of each of its points.
inline bool is_even(const Light& light) {
  if (light.illuminates_by_area()) return true;
  return light.kind == Light::Kind::kPoint && !(light.fade_power > 0.0);
}
/// The light's colour at `from`, unobstructed.
inline Rgb light_colour(const Light& light, const Vec3& from, const LightRay& ray) {
  if (is_even(light)) return light.colour;
  return light.colour * static_cast<float>(light_attenuation(light, from, ray));
}

/// Nothing worth tracing a shadow for (measured, as above).
inline bool is_dark(const Rgb& c) {
  constexpr float kDark = 1e-10f;
  if (!(std::fabs(c.r) < kDark)) [[likely]]
    return false;
  return std::fabs(c.g) < kDark && std::fabs(c.b) < kDark;
}

}  // namespace lentray::core
