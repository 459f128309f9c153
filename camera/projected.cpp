#include "camera/projected.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include "core/base/transform.h"

namespace lentray::camera {
namespace {

using core::Vec3;

constexpr double kPi = std::numbers::pi;
constexpr double kRadians = kPi / 180.0;

/// In the order of ProjectedKind; the kinds of cylinder share the last one.
constexpr std::string_view kNames[] = {"perspective",      "orthographic", "fisheye",
                                       "ultra_wide_angle", "omnimax",      "panoramic",
                                       "spherical",        "cylinder"};
constexpr std::size_t kCylinder = std::size(kNames) - 1;
static_assert(kCylinder == static_cast<std::size_t>(ProjectedKind::kCylinder1));

bool keeps_lengths(ProjectedKind kind) {
  return kind <= ProjectedKind::kOrthographic || kind == ProjectedKind::kPanoramic ||
         kind == ProjectedKind::kSpherical;
}

}  // namespace

Projected::Projected(ProjectedKind kind, const Projection& projection,
                     const ProjectedAngles& angles, std::uint32_t width, std::uint32_t height)
    : Camera(kNames[std::min(static_cast<std::size_t>(kind), kCylinder)], width, height),
      m_kind(kind), m_projection(projection), m_angles(angles), m_wide(length(projection.right)),
      m_high(length(projection.up)) {
  if (keeps_lengths(kind)) return;
  m_projection.right = normalized(m_projection.right);
  m_projection.up = normalized(m_projection.up);
  m_projection.direction = normalized(m_projection.direction);
}

Vec3 Projected::frame(double right, double up, double direction) const {
  return m_projection.right * right + m_projection.up * up + m_projection.direction * direction;
}

/// A direction `angle` off the axis, towards (x, y) of that radius.
bool Projected::around(double radius, double x, double y, double angle, Vec3& direction) const {
  const double cosine = radius > 0.0 ? x / radius : 1.0, sine = radius > 0.0 ? y / radius : 0.0;
  direction = frame(cosine * std::sin(angle), sine * std::sin(angle), std::cos(angle));
  return true;
}

bool Projected::fisheye(double x, double y, Vec3& direction) const {
  x *= 2.0 * m_wide;
  y *= 2.0 * m_high;
  const double radius = std::sqrt(x * x + y * y);
  if (radius > 1.0) return false;
  return around(radius, x, y, 0.5 * radius * m_angles.angle * kRadians, direction);
}

bool Projected::omnimax(double x, double y, Vec3& direction) const {
  constexpr double kFullAspect = 1.283458;  // of the whole dome
  const double aspect = m_wide / m_high;
  x *= 2.0;
  y *= 2.0;
  if (aspect > kFullAspect) {
    x *= aspect / kFullAspect;
    y = (y - 1.0) / kFullAspect + 1.0;
  } else if (aspect > 1.0) {
    y = (y - 1.0) / aspect + 1.0;
  } else {
    y /= aspect;
  }
  const double r = std::sqrt(x * x + y * y);
  if (r > 1.0) return false;
  const double angle = 1.411269 * r - 0.09439 * r * r * r + 0.25674 * r * r * r * r * r;
  // The projector's dome ends 45 degrees below its axis.
  const double up = (r > 0.0 ? y / r : 0.0) * std::sin(angle);
  if (up < std::tan(135.0 * kRadians) * std::cos(angle)) return false;
  return around(r, x, y, angle, direction);
}

Vec3 Projected::panoramic(double x, double y) const {
  constexpr double kStraightUp = 1e10, kTiny = 1e-10;
  const double along = (0.5 - x) * kPi, upwards = kPi * y;
  double slope = std::tan(upwards);
  if (std::fabs(0.5 * kPi - std::fabs(upwards)) < kTiny)
    slope = std::copysign(kStraightUp, upwards);
  return frame(std::cos(along), slope, std::sin(along));
}

Vec3 Projected::spherical(double x, double y) const {
  const auto turn = [](const Vec3& axis, double angle) {
    return core::Transform::axis_rotation(axis, angle);
  };
  const Vec3 lifted =
      turn(m_projection.right, -y * m_angles.vertical * kRadians).vector(m_projection.direction);
  return turn(m_projection.up, x * m_angles.horizontal * kRadians).vector(lifted);
}

bool Projected::aim(double column, double row, core::Ray& ray) const {
  const double x = column / width() - 0.5, y = 0.5 - row / height();
  const double a = x * m_angles.angle * kRadians, b = y * m_angles.angle * kRadians;
  const Vec3& start = m_projection.location;
  ray.origin = start;
  Vec3& direction = ray.direction;
  switch (m_kind) {
    case ProjectedKind::kPerspective:
      direction = m_projection.direction + m_projection.right * x + m_projection.up * y;
      break;
    case ProjectedKind::kOrthographic:
      ray.origin = start + m_projection.right * x + m_projection.up * y;
      direction = m_projection.direction;
      break;
    case ProjectedKind::kFisheye: return fisheye(x, y, direction);
    case ProjectedKind::kOmnimax: return omnimax(x, y, direction);
    case ProjectedKind::kPanoramic: direction = panoramic(x, y); break;
    case ProjectedKind::kSpherical: direction = spherical(x, y); break;
    case ProjectedKind::kUltraWideAngle: {
      const double up = b * m_high / m_wide;
      direction = frame(std::sin(a), std::sin(up), std::cos(a) * std::cos(up));
      break;
    }
    case ProjectedKind::kCylinder1: direction = frame(std::sin(a), y * m_high, std::cos(a)); break;
    case ProjectedKind::kCylinder2: direction = frame(x * m_wide, std::sin(b), std::cos(b)); break;
    case ProjectedKind::kCylinder3:
      direction = frame(std::sin(a), 0.0, std::cos(a));
      ray.origin = start + m_projection.up * (y * m_high);
      break;
    case ProjectedKind::kCylinder4:
      direction = frame(0.0, std::sin(b), std::cos(b));
      ray.origin = start + m_projection.right * (x * m_wide);
      break;
  }
  return true;
}

bool Projected::ray(double column, double row, core::Ray& ray) const {
  if (!aim(column, row, ray)) return false;
  ray.direction = normalized(ray.direction);
  return true;
}

bool Projected::sight(const core::PixelPlace& place, core::Ray& out) const {
  return aim(place.column + 0.5 + place.across, place.row + 0.5 + place.down, out);
}

std::optional<ProjectedKind> projected_kind(std::string_view word, int cylinder_type) {
  const auto kind = static_cast<int>(std::ranges::find(kNames, word) - std::begin(kNames));
  if (kind > static_cast<int>(kCylinder)) return std::nullopt;
  const bool has_type = word == "cylinder" && cylinder_type >= 2 && cylinder_type <= 4;
  return static_cast<ProjectedKind>(kind + (has_type ? cylinder_type - 1 : 0));
}

}  // namespace lentray::camera
