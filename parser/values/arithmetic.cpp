#include "parser/values/arithmetic.h"

#include <numbers>

#include "core/base/transform.h"

namespace lentray::parser {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

}  // namespace

bool unit_vector(Keyword keyword, Number& value) {
  switch (keyword) {
    case Keyword::kX: value = Number::vector({1, 0, 0}); return true;
    case Keyword::kY: value = Number::vector({0, 1, 0}); return true;
    case Keyword::kZ: value = Number::vector({0, 0, 1}); return true;
    case Keyword::kT: value = Number{{0, 0, 0, 1, 0}, 4}; return true;
    case Keyword::kU: value = Number{{1, 0, 0, 0, 0}, 2}; return true;
    case Keyword::kV: value = Number{{0, 1, 0, 0, 0}, 2}; return true;
    default: return false;
  }
}

core::Vec3 rotated(const core::Vec3& p, const core::Vec3& degrees) {
  return core::Transform::rotation(degrees).point(p);
}

core::Vec3 rotated_about(const core::Vec3& p, const core::Vec3& axis, double degrees) {
  if (core::dot(axis, axis) == 0.0) {
    return core::Vec3(-std::numeric_limits<double>::quiet_NaN());
  }
  return core::Transform::axis_rotation(axis, degrees * kDegree).point(p);
}

core::Vec3 normalised(const core::Vec3& v) {
  const double length = core::length(v);
  const bool too_short = length == 0.0 && v != core::Vec3{};
  return too_short ? core::Vec3(v.x / length, v.y / length, v.z / length) : core::normalized(v);
}

// A linear congruential generator; constants measured by the values stock prints.
double next_random(std::uint32_t& state) {
  state = state * 1812433253u + 12345u;
  return static_cast<double>(state) * (1.0 / 4294967295.0);
}

}  // namespace lentray::parser
