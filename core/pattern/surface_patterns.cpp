#include "core/pattern/surface_patterns.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/tiny.h"

namespace lentray::core {
namespace {

double ranged(double value, double low, double high) {
  const double span = high - low;
  return span == 0.0 ? value : (value - low) / span;
}

/// Into 0..1; exactly 1 stays at the upper end of a map.
double wrapped(double value, double slack) {
  if (value >= 1.0 && value - 1.0 <= slack) return value - kTiny;
  const double rest = std::fmod(value, 1.0);
  return value < 0.0 ? 1.0 + rest : rest;
}

class SlopePattern final : public Pattern {
 public:
  explicit SlopePattern(const Slope& slope) : m_slope(slope) {
    const double along = length(slope.direction), up = length(slope.altitude);
    if (!slope.point_at && along > 0.0) m_direction = slope.direction / along;
    if (up > 0.0) m_altitude = slope.altitude / up;
    // The lengths of both vectors weigh their shares.
    m_has_altitude = up > 0.0;
    if (m_has_altitude) {
      m_slope_share = along / (along + up);
      m_altitude_share = up / (along + up);
    }
  }
  double value(const Vec3&) const override { return 0.0; }
  double value_on(const Vec3& point, const SurfaceContext& surface) const override {
    if (!surface.hit) return 0.0;
    const Vec3 towards =
        m_slope.point_at ? normalized(m_slope.direction - surface.point) : m_direction;
    const double cosine = std::clamp(dot(surface.normal, towards), -1.0, 1.0);
    const double steep =
        ranged((std::asin(cosine) / std::numbers::pi * 2.0 + 1.0) * 0.5, m_slope.low, m_slope.high);
    if (!m_has_altitude) return wrapped(steep, 0.0);
    const double high = ranged(dot(point, m_altitude), m_slope.altitude_low, m_slope.altitude_high);
    return wrapped(m_slope_share * steep + m_altitude_share * high, kTiny);
  }

 private:
  Slope m_slope;
  Vec3 m_direction, m_altitude;
  double m_slope_share = 1.0, m_altitude_share = 0.0;
  bool m_has_altitude = false;
};

}  // namespace

PatternPtr make_slope(const Slope& slope) { return std::make_unique<SlopePattern>(slope); }
PatternPtr make_aoi() {
  return pattern_of([](const Vec3&, const SurfaceContext& surface) {
    if (!surface.hit) return 0.0;
    const double cosine = dot(normalized(surface.normal), normalized(surface.direction));
    return std::acos(std::clamp(cosine, -1.0, 1.0)) / std::numbers::pi;
  });
}

}  // namespace lentray::core
