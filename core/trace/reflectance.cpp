#include "core/trace/reflectance.h"

#include <algorithm>
#include <numbers>

#include "core/base/tiny.h"
#include "core/material/fresnel.h"
#include "core/noise/noise.h"

namespace lentray::core {
namespace {

double square(double x) { return x * x; }

// How much a metal keeps the light's own colour, 0 face on .. 1 grazing: a rational fit of a Fresnel curve over
// the angle as a part of the right angle. Source: that of POV-Ray 3.7.
double grazing(double cosine) {
  const double angle = std::fabs(std::acos(cosine)) / (std::numbers::pi / 2.0);
  const double fit = 0.014567225 / square(angle - 1.12) - 0.011612903;
  return std::min(1.0, std::max(0.0, fit));  // an angle that is not a number gives 0
}

Rgb metal_tint(double metallic, double cosine, const Rgb& pigment) {
  const double k = metallic * (1.0 - grazing(cosine));
  return {static_cast<float>(1.0 + k * (pigment.r - 1.0f)),
          static_cast<float>(1.0 + k * (pigment.g - 1.0f)),
          static_cast<float>(1.0 + k * (pigment.b - 1.0f))};
}

Rgb mix(const Rgb& from, const Rgb& to, double part) {
  return times(to, part) + times(from, 1.0 - part);
}

}  // namespace

Rgb metal_highlight(const Finish& finish, const LayerLight& on) {
  return on.light * metal_tint(finish.metallic, dot(on.normal, on.towards_light), on.pigment);
}

Reflectivity reflectivity(const Finish& finish, double cosine, double relative_ior,
                          const Rgb& pigment) {
  Reflectivity result;
  if (finish.reflection_fresnel) {
    result.colour =
        mix(finish.reflection_min, finish.reflection_max, fresnel(cosine, relative_ior));
    result.weight = greatest(result.colour);
  } else {
    const double grazing_part = finish.reflection_falloff == 1.0
                                    ? 1.0 - cosine
                                    : std::pow(1.0 - cosine, finish.reflection_falloff);
    if (std::fabs(grazing_part) < kTiny) {
      result.colour = finish.reflection_min;
    } else if (std::fabs(grazing_part - 1.0) < kTiny ||
               finish.reflection_min == finish.reflection_max) {
      result.colour = finish.reflection_max;
    } else {
      result.colour = mix(finish.reflection_min, finish.reflection_max, grazing_part);
    }
    result.weight = std::max(greatest(finish.reflection_min), greatest(finish.reflection_max));
  }
  if (finish.reflection_metallic != 0.0 && !result.colour.is_black()) {
    result.colour *= metal_tint(finish.reflection_metallic, cosine, pigment);
  }
  return result;
}

double film_thickness(const Finish& finish, const Vec3& point, int noise_generator) {
  if (finish.irid_turbulence == 0.0) return finish.irid_thickness;
  const Turbulence uneven{{1, 1, 1}, 5, 2.0, 0.5};
  const double noise = 2.0 * turbulence(point, uneven, noise_generator) - 1.0;
  return finish.irid_thickness * (1.0 + noise * finish.irid_turbulence);
}

Vec3 mirrored(const Vec3& incoming, const Vec3& normal, const Vec3& surface_normal) {
  const Vec3 out = incoming + normal * (-2.0 * dot(incoming, normal));
  const double through = dot(out, surface_normal);
  if (!(through < 0.0)) return out;
  if (dot(out, normal) < 0.0) {
    return incoming + surface_normal * (-2.0 * dot(incoming, surface_normal));
  }
  return out + surface_normal * (-2.0 * through);
}

Rgb film_tint(const Finish& finish, double thickness, const Vec3& wavelengths, const Vec3& normal,
              const Vec3& from_light, const Vec3& eye) {
  const double cosines = std::fabs(dot(normal, from_light)) + std::fabs(dot(normal, eye));
  const double phase = 2.0 * std::numbers::pi * thickness * cosines;
  Rgb tint;
  for (int c = 0; c < 3; ++c) {
    tint[c] = static_cast<float>(1.0 + finish.irid * std::cos(phase / wavelengths[c]));
  }
  return tint;
}

}  // namespace lentray::core
