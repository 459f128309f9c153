#include "core/pattern/shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace lentray::core {
namespace {

/// Distance 0..1 turned into density 1..0.
double fall(double distance) {
  if (distance < 0.0) return 1.0;
  return distance > 1.0 ? 0.0 : 1.0 - distance;
}

}  // namespace

double quilt_curve(double t, double control0, double control1) {
  // A cubic Bezier from 0 to 1, scaled so that a cell's corner, sqrt(3/4) away, is met.
  const double rest = 1.0 - t;
  const double bezier =
      t * t * t + 3.0 * t * rest * rest * control0 + 3.0 * t * t * rest * control1;
  return bezier * (1.0 / std::sqrt(0.75));
}

Vec3 quilt_offset(const Vec3& point, double control0, double control1) {
  // Whole negative coordinates belong to the cell below.
  const auto place = [](double v) {
    const double cell = v >= 0.0 ? std::floor(v) : -std::floor(-v) - 1.0;
    return v - cell - 0.5;
  };
  const Vec3 q{place(point.x), place(point.y), place(point.z)};
  return q * quilt_curve(length(q), control0, control1);
}

PatternPtr make_gradient(const Vec3& unit_direction) {
  return pattern_of([unit_direction](const Vec3& p) {
    const double along = dot(p, unit_direction);
    return along > 1.0 ? std::fmod(along, 1.0) : along;
  });
}
PatternPtr make_onion() {
  return pattern_of([](const Vec3& p) { return std::fmod(length(p), 1.0); });
}
PatternPtr make_radial() {
  return pattern_of([](const Vec3& p) {
    if (std::fabs(p.x) < 0.001 && std::fabs(p.z) < 0.001) return 0.25;
    return 0.25 + (std::atan2(p.x, p.z) + std::numbers::pi) / (2.0 * std::numbers::pi);
  });
}
PatternPtr make_spherical() {
  return pattern_of([](const Vec3& p) { return fall(length(p)); });
}
PatternPtr make_cylindrical() {
  return pattern_of([](const Vec3& p) { return fall(std::sqrt(p.x * p.x + p.z * p.z)); });
}
PatternPtr make_planar() {
  return pattern_of([](const Vec3& p) { return fall(std::fabs(p.y)); });
}
PatternPtr make_boxed() {
  return pattern_of([](const Vec3& p) {
    return fall(std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)}));
  });
}
PatternPtr make_leopard() {
  return pattern_of([](const Vec3& p) {
    const double mean = (std::sin(p.x) + std::sin(p.y) + std::sin(p.z)) / 3.0;
    return mean * mean;
  });
}
PatternPtr make_quilted(double control0, double control1) {
  return pattern_of([control0, control1](const Vec3& p) {
    const Vec3 q = quilt_offset(p, control0, control1);
    return (std::fabs(q.x) + std::fabs(q.y) + std::fabs(q.z)) / 3.0;
  });
}
PatternPtr make_function(std::shared_ptr<const Function> function) {
  return pattern_of([function = std::move(function)](const Vec3& p) {
    const std::array<double, 3> arguments = {p.x, p.y, p.z};
    const double result = function->evaluate(arguments);
    return result > 1.0 ? std::fmod(result, 1.0) : result;
  });
}
PatternPtr make_inside(std::function<bool(const Vec3&)> inside) {
  return pattern_of([inside = std::move(inside)](const Vec3& p) { return inside(p) ? 1.0 : 0.0; });
}

}  // namespace lentray::core
