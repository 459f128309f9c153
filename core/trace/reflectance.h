// What a finish does with light: diffuse, highlights, mirror strength. World space, unit
// vectors unless said otherwise. Pure functions.
// Source: reference manual 3.7, "Finish"; formulae held against stock by
// tests/image/shading_finish_test.cpp.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/base/color.h"
#include "core/base/vec3.h"
#include "core/material/finish.h"

namespace lentray::core {

inline Rgb times(const Rgb& c, double s) {
  return {static_cast<float>(c.r * s), static_cast<float>(c.g * s), static_cast<float>(c.b * s)};
}

inline float greatest(const Rgb& c) {
  const float rg = c.r > c.g ? c.r : c.g;
  return rg > c.b ? rg : c.b;
}

/// What passes through a pigment: filtered and unfiltered together.
inline Rgb passed(const Colour& c) {
  return {c.rgb.r * c.filter + c.transmit, c.rgb.g * c.filter + c.transmit,
          c.rgb.b * c.filter + c.transmit};
}

/// `cosine`: of the angle between normal and light, of either sign. `light` is what arrives of it.
/// `amount`: `diffuse` or its value for the back. `opacity`: of the layer, its share of the light.
/// `random` in [0, 1) is used by crand alone.
inline Rgb diffuse_light(const Finish& finish, double cosine, const Rgb& light, const Rgb& pigment,
                         double amount, double opacity, double random) {
  if (!(amount > 0.0)) return {};
  cosine = std::fabs(cosine);
  double intensity = finish.brilliance == 1.0 ? cosine : std::pow(cosine, finish.brilliance);
  intensity *= amount * opacity;
  if (finish.crand > 0.0) intensity -= random * finish.crand;
  return times(pigment, intensity) * light;
}

/// One light on one layer.
struct LayerLight {
  Vec3 towards_light;
  Vec3 eye;     ///< direction of the ray that looks
  Vec3 normal;  ///< of the layer, facing the eye
  Rgb light;    ///< what arrives of the light
  Rgb pigment;
};
/// False: lights make nothing of it, whatever arrives of them.
inline bool shows_light(const Finish& finish) {
  return finish.diffuse != 0.0 || finish.diffuse_back != 0.0 || finish.specular != 0.0 ||
         finish.phong != 0.0;
}
inline bool has_highlights(const Finish& finish) {
  return finish.phong > 0.0 || finish.specular > 0.0;
}
/// x to a power, x not negative. Whole powers, as most are, are multiplied: less than half the price of pow, and
/// as near as it but for the last digits of a double, of which colours keep half.
inline double power(double x, double exponent) {
  constexpr int kMost = 1024;
  const int whole = exponent > 0.0 && exponent <= kMost ? static_cast<int>(exponent) : 0;
  if (whole == 0 || whole != exponent) return std::pow(x, exponent);
  double result = 1.0;
  for (int left = whole;; x *= x) {
    if (left & 1) result *= x;
    left >>= 1;
    if (left == 0) return result;
  }
}
/// Of the cosine between the light and the mirrored ray.
inline double phong_of(const Finish& finish, double cosine) {
  if (!(cosine > 0.0)) return 0.0;
  // Below 0.0008 a high power underflows: it is cut there.
  if (finish.phong_size >= 60.0 && cosine <= 0.0008) return 0.0;
  return finish.phong * power(cosine, finish.phong_size);
}
/// Of the cosine between the normal and the direction halfway from light to eye.
inline double specular_of(const Finish& finish, double cosine) {
  if (!(cosine > 0.0)) return 0.0;
  return finish.specular * power(cosine, finish.roughness_exponent);
}
inline double phong_intensity(const Finish& finish, const LayerLight& on) {
  const Vec3 mirrored = on.eye + on.normal * (-2.0 * dot(on.eye, on.normal));
  return phong_of(finish, dot(mirrored, on.towards_light));
}
inline double specular_intensity(const Finish& finish, const LayerLight& on) {
  const Vec3 halfway = (on.towards_light - on.eye) * 0.5;
  const double size = length(halfway);
  if (!(size > 0.0)) return 0.0;
  return specular_of(finish, dot(halfway, on.normal) / size);
}
/// False: no highlight of that light, nor what strengthens it less than 1e10 times, changes a sum.
inline bool may_shine(const Finish& finish, const LayerLight& on) {
  constexpr double kNothing = 1e-60;  // far below the least float
  const Rgb& c = on.light;
  const double most = std::max({std::fabs(c.r), std::fabs(c.g), std::fabs(c.b)});
  const double phong = finish.phong > 0.0 ? phong_intensity(finish, on) : 0.0;
  const double specular = finish.specular > 0.0 ? specular_intensity(finish, on) : 0.0;
  return !((phong + specular) * most < kNothing);
}
inline bool reflects(const Finish& finish) {
  return !finish.reflection_max.is_black() || !finish.reflection_min.is_black();
}

/// The light as a metal's highlights show it.
Rgb metal_highlight(const Finish& finish, const LayerLight& on);
/// phong and specular, metallic or not.
[[gnu::always_inline]] inline Rgb highlights(const Finish& finish, const LayerLight& on) {
  Rgb sum;
  const Rgb light = finish.metallic > 0.0 ? metal_highlight(finish, on) : on.light;
  if (finish.phong > 0.0) sum += times(light, phong_intensity(finish, on));
  if (finish.specular > 0.0) sum += times(light, specular_intensity(finish, on));
  return sum;
}

/// What a thin film (`irid`) makes of light from `from_light` on its way to the eye: a factor a
/// channel, about 1. `thickness` of the film there, in the unit of `wavelengths`.
Rgb film_tint(const Finish& finish, double thickness, const Vec3& wavelengths, const Vec3& normal,
              const Vec3& from_light, const Vec3& eye);

/// How thick the film is at a point (`irid { turbulence }`), world space.
double film_thickness(const Finish& finish, const Vec3& point, int noise_generator);

/// The mirrored direction of a ray at a layer's normal, not unit. A perturbed normal may send it through
/// the real surface: `surface_normal` sends it back.
Vec3 mirrored(const Vec3& incoming, const Vec3& normal, const Vec3& surface_normal);

/// Ratio of interiors as the Fresnel formula takes it: beyond the surface over before it.
struct Reflectivity {
  Rgb colour;
  float weight = 0.0f;  ///< the greatest share of any channel, for adc_bailout
};
/// `cosine` is that of the angle of incidence, positive on the side of the eye.
Reflectivity reflectivity(const Finish& finish, double cosine, double relative_ior,
                          const Rgb& pigment);

}  // namespace lentray::core
