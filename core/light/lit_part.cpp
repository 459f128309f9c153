#include "core/light/lit_part.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/tiny.h"

namespace lentray::core {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();

/// Solutions of a t^2 + 2 b t + c = 0, the smaller first.
std::optional<std::pair<double, double>> roots(double a, double b, double c) {
  const double under_root = b * b - a * c;
  if (!(under_root > 0.0)) return std::nullopt;
  const double root = std::sqrt(under_root);
  const double t1 = (-b - root) / a, t2 = (-b + root) / a;
  return std::minmax({t1, t2});
}

/// The ray against the axis from the light's position on.
struct AlongAxis {
  AlongAxis(const Light& light, const Ray& ray)
      : to_origin(ray.origin - light.position), speed(dot(ray.direction, light.direction)),
        start(dot(to_origin, light.direction)), b(dot(to_origin, ray.direction)),
        c(length_squared(to_origin)) {}
  double at(double t) const { return start + t * speed; }
  Vec3 to_origin;
  double speed, start;  ///< of the place on the axis: a unit of the ray, at its origin
  double b, c;          ///< of the squared distance from the position, t^2 + 2 b t + c
};

std::optional<RayPart> in_cone(const Light& light, const Ray& ray) {
  const double cosine = light.falloff;
  if (!(cosine > kTiny)) return RayPart{0.0, kInf};
  const AlongAxis axis(light, ray);
  const double widening = 1.0 / (cosine * cosine);
  const double a = 1.0 - axis.speed * axis.speed * widening;
  const double b = axis.b - axis.start * axis.speed * widening;
  const double c = axis.c - axis.start * axis.start * widening;
  if (a == 0.0) return std::nullopt;
  const auto crossings = roots(a, b, c);
  if (!crossings) return std::nullopt;
  const auto [near, far] = *crossings;
  const bool near_ahead = axis.at(near) > 0.0, far_ahead = axis.at(far) > 0.0;
  if (near_ahead && far_ahead) return RayPart{near, far};
  if (far_ahead) return RayPart{far, kInf};
  if (near_ahead) return RayPart{-kInf, near};
  return std::nullopt;
}

std::optional<RayPart> in_cylinder(const Light& light, const Ray& ray) {
  const AlongAxis axis(light, ray);
  const double c = axis.c - axis.start * axis.start - light.falloff * light.falloff;
  const double a = 1.0 - axis.speed * axis.speed;
  RayPart part{-kInf, kInf};
  if (a > kTiny) {
    const auto crossings = roots(a, axis.b - axis.start * axis.speed, c);
    if (!crossings) return std::nullopt;
    part = {crossings->first, crossings->second};
  } else if (c >= 0.0) {
    return std::nullopt;
  }
  // What lies behind the light is dark.
  const bool starts_ahead = axis.at(part.from) > 0.0, ends_ahead = axis.at(part.to) > 0.0;
  if (!starts_ahead && !ends_ahead) return std::nullopt;
  if (!starts_ahead) part.from = 0.0;  // not where the axis begins
  if (!ends_ahead) part.to = -axis.start / axis.speed;
  return part;
}

}  // namespace

std::optional<RayPart> lit_part(const Light& light, const Ray& ray, double length) {
  if (light.shadowless) return std::nullopt;
  if (light.kind == Light::Kind::kPoint) return RayPart{0.0, length};
  const auto part =
      light.kind == Light::Kind::kSpot ? in_cone(light, ray) : in_cylinder(light, ray);
  if (!part || !(part->from < length) || !(part->to > 0.0)) return std::nullopt;
  return RayPart{std::max(part->from, 0.0), std::min(part->to, length)};
}

}  // namespace lentray::core
