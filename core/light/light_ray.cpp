#include "core/light/light_ray.h"

#include <cmath>

#include "core/base/tiny.h"

namespace lentray::core {
namespace {

// Soft edge: 0 below `low`, 1 from `high` on, 3x^2 - 2x^3 between.
double smooth_edge(double low, double high, double x) {
  if (x < low) return 0.0;
  if (x >= high) return 1.0;
  const double s = (x - low) / (high - low);
  return (3.0 - 2.0 * s) * s * s;
}

/// The exponents that scenes use most are quicker without std::pow, and at least as exact.
double power(double base, double exponent) {
  if (exponent == 1.0) return base;
  if (exponent == 2.0) return base * base;
  return std::pow(base, exponent);
}

double spot_factor(const Light& light, const LightRay& ray) {
  double cosine = dot(ray.direction, light.direction);
  if (ray.distance > 0.0) cosine = -cosine;
  if (!(cosine > 0.0)) return 0.0;
  double factor = 1.0;
  if (light.radius > 0.0 && cosine < light.radius) {
    factor = smooth_edge(light.falloff, light.radius, cosine);
    if (factor == 0.0) return 0.0;
  }
  return light.tightness == 0.0 ? factor : power(cosine, light.tightness) * factor;
}

double cylinder_factor(const Light& light, const Vec3& from) {
  const Vec3 away = from - light.position;
  const double along = dot(away, light.direction);
  if (!(along > 0.0)) return 0.0;
  const double off_axis = length(away - along * light.direction);
  if (!(off_axis < light.falloff)) return 0.0;
  const double inward = 1.0 - off_axis / light.falloff;
  double factor = light.tightness == 0.0 ? 1.0 : power(inward, light.tightness);
  if (light.radius > 0.0 && off_axis > light.radius) {
    factor *= smooth_edge(0.0, 1.0 - light.radius / light.falloff, inward);
  }
  return factor;
}

}  // namespace

LightRay directed_light_ray(const Light& light, const Vec3& from, const Vec3& offset) {
  const Vec3 centre = light.position + offset;
  LightRay ray;
  if (light.kind == Light::Kind::kCylinder) {
    const Vec3 axis = centre - light.point_at;
    const double axis_length = length(axis);
    ray.distance = dot(centre - from, axis) / axis_length;
    ray.direction = axis / axis_length;
  } else {
    const Vec3 to = centre - from;
    ray.distance = length(to);
    ray.direction = to / ray.distance;
  }
  if (!light.parallel) return ray;
  // All rays of a parallel light are one direction; the length is that of the projection.
  const Vec3 back = light.has_area ? normalized(centre - light.point_at) : -light.direction;
  ray.distance *= dot(back, ray.direction);
  ray.direction = back;
  return ray;
}

double beam_factor(const Light& light, const Vec3& from, const LightRay& ray) {
  if (light.kind == Light::Kind::kSpot) return spot_factor(light, ray);
  if (light.kind == Light::Kind::kCylinder) return cylinder_factor(light, from);
  return 1.0;
}

double light_attenuation(const Light& light, const Vec3& from, const LightRay& ray) {
  double factor = beam_factor(light, from, ray);
  if (factor > 0.0 && light.fade_power > 0.0 && std::fabs(light.fade_distance) > kTiny) {
    factor *= 2.0 / (1.0 + power(ray.distance / light.fade_distance, light.fade_power));
  }
  return factor;
}

}  // namespace lentray::core
