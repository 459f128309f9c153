// The way from a point to a light, and how much of the light's colour goes that way before
// anything stands in it. World space. Pure functions of their arguments.
// Source: reference manual 3.7, "Light Source" (spotlights, cylinders, parallel, fading);
// signs and limits as measured on stock (tests/image/shading_lights_test.cpp).
#pragma once

#include "core/base/vec3.h"
#include "core/light/light.h"

namespace lentray::core {

struct LightRay {
  Vec3 direction;         ///< unit, towards the light
  double distance = 0.0;  ///< to the light, or to its plane; negative behind a parallel light
};

/// For lights whose rays do not all go to its position: parallel ones and cylinders.
LightRay directed_light_ray(const Light& light, const Vec3& from, const Vec3& offset);

/// Ray from `from` to the light's position moved by `offset` (a sample of an area light).
inline LightRay light_ray(const Light& light, const Vec3& from, const Vec3& offset = {}) {
  if (light.parallel || light.kind == Light::Kind::kCylinder) {
    return directed_light_ray(light, from, offset);
  }
  const Vec3 to = light.position + offset - from;
  const double distance = length(to);
  return {to * (1.0 / distance), distance};
}

/// Factor of the cone, the cylinder and of fading; 0 outside.
double light_attenuation(const Light& light, const Vec3& from, const LightRay& ray);

/// The light's colour at `from`, unobstructed.
inline Rgb light_colour(const Light& light, const Vec3& from, const LightRay& ray) {
  if (light.kind == Light::Kind::kPoint && !(light.fade_power > 0.0)) return light.colour;
  return light.colour * static_cast<float>(light_attenuation(light, from, ray));
}

/// Certain without a square root that the light is behind the surface; if false, it may be.
inline bool surely_behind(const Light& light, const Vec3& from, const Vec3& normal) {
  return !light.parallel && light.kind != Light::Kind::kCylinder &&
         dot(normal, light.position - from) < 0.0;
}

/// Nothing worth tracing a shadow for (stock's threshold).
inline bool is_dark(const Rgb& c) {
  constexpr float kDark = 1e-10f;
  return c.r < kDark && c.r > -kDark && c.g < kDark && c.g > -kDark && c.b < kDark && c.b > -kDark;
}

}  // namespace lentray::core
