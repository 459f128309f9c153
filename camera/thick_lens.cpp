#include "camera/thick_lens.h"

#include <algorithm>
#include <cmath>

namespace lentray::camera {

ThickLens::ThickLens(const LensParameters& lens)
    : m_pitch(lens.pitch), m_focal_length(lens.focal_length), m_ior(lens.ior),
      m_radius(lens.radius()), m_edge(point_at(0.5 * lens.pitch).depth), m_rays(lens.rays) {}

ThickLens::Point ThickLens::point_at(double across) const {
  const double inwards = std::sqrt(std::max(0.0, (m_radius - across) * (m_radius + across)));
  return {across, inwards, across * across / (m_radius + inwards)};
}

bool ThickLens::incidence(const Point& point, double offset, double& sine) const {
  const double x = offset - point.across, z = m_focal_length - point.depth;
  if (std::fabs(offset) > 0.5 * m_pitch) {
    // Under another lens. The way must come in below the edge; from there on the glass is convex.
    const double along = (std::copysign(0.5 * m_pitch, offset) - point.across) / x;
    if (point.depth + along * z < m_edge) return false;
  }
  sine = (x * point.inwards + z * point.across) / std::hypot(x, z);
  return true;
}

LensRayEnd ThickLens::leave(double offset, double across, const SlopeAlong& along,
                            SheetExit& out) const {
  const Point point = point_at(across);
  double sine = 0.0;
  if (!incidence(point, offset, sine)) return LensRayEnd::kHidden;
  // With T the tangent in the air against the normal, S the sine in the glass, the cross-section's
  // index n'^2 = n^2 + (n^2 - 1) (rise cos t)^2 and cos t = (inwards + T across)/(R sqrt(1 + T^2)),
  // T^2/(1 + T^2) = n'^2 S^2 is a quadratic equation for T. Its root on S's side nearest to 0 holds.
  // It stays one where the rise is linear in tan t: rise cos t = (g + h T)/sqrt(1 + T^2).
  const double rise = along.at_zero;
  const double n2 = m_ior * m_ior, skew = (n2 - 1.0) * rise * rise;
  const double s = sine / m_radius, nx = point.across / m_radius, nz = point.inwards / m_radius;
  double c = n2 + skew * nz * nz, b = skew * nz * nx;
  double a = 1.0 - s * s * (n2 + skew * nx * nx);
  if (along.lean != 0.0) {
    const double g = rise * nz - along.lean * nx, h = rise * nx + along.lean * nz;
    c = n2 + (n2 - 1.0) * g * g;
    b = (n2 - 1.0) * g * h;
    a = 1.0 - s * s * (n2 + (n2 - 1.0) * h * h);
  }
  const double under = s * s * b * b + a * c;
  const double root = under >= 0.0 ? std::sqrt(under) - s * b : 0.0;  // 0: there is none
  if (!(root > 0.0)) {
    // A ray that goes on through other lenses may rise less steeply here, and leave.
    const bool may_leave = (rise != 0.0 || along.lean != 0.0) && m_ior * std::fabs(s) < 1.0;
    return may_leave ? spill(point, sine, along, out) : LensRayEnd::kReflected;
  }
  const double tangent = s * c / root;
  const double x = tangent * nz - nx, z = nz + tangent * nx;
  const double size = std::sqrt(1.0 + tangent * tangent);
  if (z > 0.0 && !meets_next_lens({point.across, -point.inwards, -x / size, -z / size})) {
    out = {point.across, point.depth, x / z};
    return LensRayEnd::kLeaves;
  }
  return spill(point, sine, along, out);
}

bool ThickLens::meets_next_lens(const AirRay& ray) const {
  const double side = ray.dx > 0.0 ? m_pitch : -m_pitch;
  const double towards = (side - ray.x) * ray.dx - ray.z * ray.dz;
  // The distance to the next circle's middle, squared, less R^2: the point lies on a circle of R.
  const double outside = m_pitch * m_pitch - 2.0 * side * ray.x;
  return towards > 0.0 && towards * towards > outside;
}

void ThickLens::enter_next_lens(AirRay& ray, double side) const {
  const double towards = (side - ray.x) * ray.dx - ray.z * ray.dz;
  const double outside = std::max(0.0, m_pitch * m_pitch - 2.0 * side * ray.x);
  const double root = std::sqrt(std::max(0.0, towards * towards - outside));
  const double way = outside / (towards + root);
  ray.x += way * ray.dx - side;
  ray.z += way * ray.dz;
  const double back = m_radius / std::hypot(ray.x, ray.z);
  ray.x *= back;
  ray.z *= back;
}

bool ThickLens::pass_lens(AirRay& ray, double ior) const {
  const double nx = ray.x / m_radius, nz = ray.z / m_radius;
  const double cosine = -(ray.dx * nx + ray.dz * nz);
  const double gx = (ray.dx + cosine * nx) / ior, gz = (ray.dz + cosine * nz) / ior;
  const double inside = std::sqrt(std::max(0.0, 1.0 - gx * gx - gz * gz));
  const double ix = gx - inside * nx, iz = gz - inside * nz;
  // A chord meets its circle at the same angle at both ends, so that what entered can leave.
  const double chord = 2.0 * m_radius * inside;
  ray.x += chord * ix;
  ray.z += chord * iz;
  if (std::fabs(ray.x) > 0.5 * m_pitch || ray.z >= 0.0) return false;  // to the print
  const double ex = ray.x / m_radius, ez = ray.z / m_radius;
  ray.dx = ior * (ix - inside * ex) + cosine * ex;
  ray.dz = ior * (iz - inside * ez) + cosine * ez;
  return true;
}

LensRayEnd ThickLens::follow(const Point& point, double sine, double ior, SheetExit& out) const {
  constexpr int kMostLenses = 64;
  const double nx = point.across / m_radius, nz = point.inwards / m_radius;
  const double s = ior * sine / m_radius;
  if (!(s * s < 1.0)) return LensRayEnd::kReflected;
  const double cosine = std::sqrt(1.0 - s * s);
  AirRay ray{point.across, -point.inwards, cosine * nx - s * nz, -cosine * nz - s * nx};
  double axis = 0.0;
  for (int lens = 0; lens < kMostLenses; ++lens) {
    if (!meets_next_lens(ray)) {
      if (!(ray.dz < 0.0)) return LensRayEnd::kReturns;
      const double depth = ray.x * ray.x / (m_radius - ray.z);
      out = {axis + ray.x, depth, ray.dx / ray.dz};
      return lens == 0 ? LensRayEnd::kLeaves : LensRayEnd::kSpills;
    }
    const double side = ray.dx > 0.0 ? m_pitch : -m_pitch;
    enter_next_lens(ray, side);
    axis += side;
    if (!pass_lens(ray, ior)) return LensRayEnd::kReturns;
  }
  return LensRayEnd::kReturns;
}

LensRayEnd ThickLens::spill(const Point& point, double sine, const SlopeAlong& along,
                            SheetExit& out) const {
  const double rise = along.at_zero;
  if (rise == 0.0 && along.lean == 0.0) return follow(point, sine, m_ior, out);
  // (rise cos t)^2 of the ray that leaves at last, and so the index, is the same in all lenses on its way:
  // a number from 0 to rise^2 (and the square of what it leans) that makes itself. It is found between
  // parts of that range, which are smaller and smaller towards 0, where the ray grazes the sheet.
  constexpr int kEven = 16, kGrazing = 12, kHalvings = 60;
  constexpr double kSolved = 1e-13;
  const double n2 = m_ior * m_ior, whole = rise * rise + along.lean * along.lean;
  const auto edge = [&](int part) {
    if (part == 0) return 0.0;
    return part > kGrazing ? whole * (part - kGrazing) / kEven
                           : std::ldexp(whole / kEven, part - kGrazing - 1);
  };
  LensRayEnd end = LensRayEnd::kReflected, dark = LensRayEnd::kReflected;
  double off = 0.0;
  enum class Guess { kSmall, kLarge, kDark };
  const auto try_out = [&](double guess) {
    end = follow(point, sine, std::sqrt(n2 + (n2 - 1.0) * guess), out);
    if (end == LensRayEnd::kReturns) dark = end;
    if (!shows(end)) return Guess::kDark;
    const double there = along.at(out.slope);
    off = (along.lean == 0.0 ? whole : there * there) / (1.0 + out.slope * out.slope) - guess;
    return off >= 0.0 ? Guess::kSmall : Guess::kLarge;
  };
  Guess last = try_out(0.0);
  for (int part = 1; part <= kGrazing + kEven; ++part) {
    const Guess now = try_out(edge(part));
    if (now != last && last != Guess::kLarge && now != Guess::kSmall) {
      double low = edge(part - 1), high = edge(part);
      for (int i = 0; i < kHalvings; ++i) {
        const double middle = 0.5 * (low + high);
        (try_out(middle) == last ? low : high) = middle;
      }
      try_out(last == Guess::kDark ? high : low);
      if (shows(end) && std::fabs(off) <= kSolved * whole) return end;
    }
    last = now;
  }
  return dark;
}

bool ThickLens::is_dark(double offset, const SlopeAlong& along) const {
  for (std::uint32_t j = 0; j < m_rays; ++j) {
    SheetExit exit;
    const std::uint32_t from_middle = (m_rays / 2 + j) % m_rays;
    if (shows(leave(offset, middle(from_middle), along, exit))) return false;
  }
  return true;
}

}  // namespace lentray::camera
