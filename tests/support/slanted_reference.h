// Rays of slanted lens sheets, worked out apart from the program: pixels are placed in the print in
// mm, rays refract as vectors in three dimensions, and what has to fit is found by bisection. In long
// double. The sheet lies across z at the origin, its lengths are mm; +z leads into the display.
// Pure.
#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "tests/support/thick_places.h"

namespace lentray::test {

using SlantReal = long double;
using SlantVector = std::array<SlantReal, 3>;

/// A sheet, its print and its eye.
struct SlantReference {
  enum class Model { kParaxial, kPinhole, kThick };
  Model model = Model::kParaxial;
  double slant = 0.0;  ///< degrees; positive: tops of the lenses to the right
  double pitch = 1.124, focal_length = 3.03, ior = 1.6, pixels = 7.0;
  double distance = 0.0;  ///< V; 0: infinite
  int columns = 70, rows = 40;
  double row_by_column = 1.0;  ///< a pixel's height by its width
  double eye_slope_x = 0.0, eye_slope_y = 0.0;
  int rays = 1;  ///< of the thick model

  SlantReal angle() const { return slant * std::numbers::pi_v<SlantReal> / 180.0L; }
  SlantReal inverse() const { return distance > 0.0 ? 1.0L / distance : 0.0L; }
  SlantReal print_pitch() const {
    return pitch * (1.0L + focal_length * inverse() / static_cast<SlantReal>(ior));
  }
  /// A pixel in the sheet's size, which is smaller than in the print by pitch/print_pitch().
  SlantReal column_width() const { return pitch / (pixels * std::cos(angle())); }
  SlantReal row_height() const { return column_width() * row_by_column; }
  SlantReal width() const { return columns * column_width(); }
  SlantReal height() const { return rows * row_height(); }
  SlantReal radius() const { return focal_length * (ior - 1.0L) / ior; }
};

/// A ray in the world, and the light's straight way in the glass.
struct SlantRay {
  SlantVector leaves{}, slope{};  ///< where it leaves the sheet; dz = 1
  SlantVector in_print{};         ///< where the light comes from
};

/// Where a pixel lies: its lens's axis and its offset from that, across the lens.
struct SlantPixel {
  SlantReal axis = 0.0L, cell_offset = 0.0L, lens_offset = 0.0L, height = 0.0L;
  std::int64_t lens = 0, view = 0;
};

inline SlantReal slant_shift(const SlantReference& s) {
  const SlantReal a = s.angle(), sx = s.eye_slope_x, sy = s.eye_slope_y;
  const SlantReal across = sx * std::cos(a) - sy * std::sin(a);
  if (s.distance > 0.0 || s.model == SlantReference::Model::kParaxial) {
    return across * s.focal_length / s.ior;
  }
  // The light of the middle view, as a unit vector; its parts along the sheet are n times as large
  // outside.
  const SlantReal size = std::sqrt(sx * sx + sy * sy + 1.0L);
  const SlantReal along_sheet = std::sqrt(sx * sx + sy * sy) / size / s.ior;
  return across / size / s.ior / std::sqrt(1.0L - along_sheet * along_sheet) * s.focal_length;
}

inline SlantPixel slant_pixel(const SlantReference& s, int column, int row) {
  const SlantReal a = s.angle(), larger = s.print_pitch() / s.pitch;
  const SlantReal y = (0.5L * s.rows - row - 0.5L) * s.row_height();
  const SlantReal x = (column + 0.5L - 0.5L * s.columns) * s.column_width();
  const SlantReal across = (x * std::cos(a) - y * std::sin(a)) * larger;  // in the print
  const SlantReal lenses = s.columns / static_cast<SlantReal>(s.pixels);
  const SlantReal lens = std::floor(across / s.print_pitch() + 0.5L * lenses + 1e-9L);
  const SlantReal middle = lens + 0.5L - 0.5L * lenses;
  SlantPixel out;
  out.axis = middle * s.pitch;
  out.cell_offset = across - middle * s.print_pitch();
  const SlantReal cell = out.cell_offset / s.print_pitch() + 0.5L;
  out.lens = static_cast<std::int64_t>(lens);
  out.view = static_cast<std::int64_t>(std::floor(cell * s.pixels + 1e-9L));
  out.lens_offset = across - out.axis + slant_shift(s);
  out.height = y;
  return out;
}

/// Light from (offset, climb, f) in the lens's frame to the surface at `across`, outside: the slopes
/// across and along the lens. Empty: it is totally reflected.
inline std::optional<std::array<SlantReal, 2>> slant_refract(const SlantReference& s,
                                                             SlantReal offset, SlantReal across,
                                                             SlantReal climb) {
  const SlantReal r = s.radius();
  const bool flat = s.model == SlantReference::Model::kPinhole;
  const SlantReal depth = flat ? 0.0L : r - std::sqrt(r * r - across * across);
  SlantVector d{across - offset, -climb, depth - s.focal_length};
  const SlantReal size = std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
  for (SlantReal& x : d) x /= size;
  const SlantVector normal{flat ? 0.0L : across / r, 0.0L,
                           flat ? -1.0L : -std::sqrt(r * r - across * across) / r};  // outwards
  const SlantReal cosine = d[0] * normal[0] + d[2] * normal[2];
  const SlantReal under = 1.0L - s.ior * static_cast<SlantReal>(s.ior) * (1.0L - cosine * cosine);
  if (under <= 0.0L) return std::nullopt;
  const SlantReal more = std::sqrt(under) - s.ior * cosine;
  SlantVector out{};
  for (int i = 0; i < 3; ++i) out[i] = s.ior * d[i] + more * normal[i];
  if (out[2] >= 0.0L) return std::nullopt;
  return std::array<SlantReal, 2>{out[0] / out[2], out[1] / out[2]};
}

/// The straight way from the print to that point of the surface stays in the glass.
inline bool slant_stays_inside(const SlantReference& s, SlantReal offset, SlantReal across) {
  const SlantReal r = s.radius(), half = 0.5L * s.pitch;
  if (std::fabs(offset) <= half) return true;
  const SlantReal depth = r - std::sqrt(r * r - across * across);
  const SlantReal edge = r - std::sqrt(r * r - half * half);
  const SlantReal part = (std::copysign(half, offset) - across) / (offset - across);
  return depth + part * (s.focal_length - depth) >= edge;
}

/// The ray of a pixel; of the thick model that of this number. Empty: there is none.
inline std::optional<SlantRay> slant_ray(const SlantReference& s, int column, int row,
                                         int number = 0) {
  SlantPixel p = slant_pixel(s, column, row);
  const bool thick = s.model == SlantReference::Model::kThick;
  const ThickPlace place = thick ? thick_place(p.lens, row, p.view, number, s.rays) : ThickPlace{};
  p.height -= place.down * s.row_height();
  const SlantReal a = s.angle(), cosine = std::cos(a), sine = std::sin(a);
  const SlantReal rise = p.height * s.inverse() + s.eye_slope_y;
  SlantRay out;
  if (s.model == SlantReference::Model::kParaxial) {
    const SlantReal x = (p.axis + p.height * sine) / cosine;
    const SlantReal aside = s.ior * p.cell_offset / cosine / s.focal_length;  // of the view's eye
    out.leaves = {x, p.height, 0.0L};
    out.slope = {aside + x * s.inverse() + s.eye_slope_x, rise, 1.0L};
    return out;
  }
  const SlantReal across = (place.part - 0.5L) * s.pitch;
  const SlantReal depth =
      thick ? s.radius() - std::sqrt(s.radius() * s.radius() - across * across) : 0.0L;
  // The more the line climbs in the glass, the more it rises outside.
  SlantReal low = -20.0L, high = 20.0L;
  const auto off = [&](SlantReal climb) -> std::optional<SlantReal> {
    const auto to = slant_refract(s, p.lens_offset, across, climb);
    if (!to) return std::nullopt;
    return (*to)[1] * cosine - (*to)[0] * sine - rise;
  };
  // Steep lines are totally reflected: towards the middle there are some that are not.
  if (thick && !slant_stays_inside(s, p.lens_offset, across)) return std::nullopt;
  if (!off(0.0L)) return std::nullopt;
  for (int i = 0; i < 2000 && !off(low); ++i) low *= 0.99L;
  for (int i = 0; i < 2000 && !off(high); ++i) high *= 0.99L;
  if (!off(low) || !off(high) || *off(low) * *off(high) > 0.0L) return std::nullopt;
  const bool grows = *off(high) > 0.0L;
  for (int i = 0; i < 130; ++i) {
    const SlantReal middle = 0.5L * (low + high);
    ((*off(middle) > 0.0L) == grows ? high : low) = middle;
  }
  const SlantReal climb = 0.5L * (low + high);
  const auto to = slant_refract(s, p.lens_offset, across, climb);
  const SlantReal u = p.axis + across, w = (p.height + u * sine) / cosine;
  out.leaves = {u * cosine + w * sine, p.height, depth};
  out.slope = {(*to)[0] * cosine + (*to)[1] * sine, (*to)[1] * cosine - (*to)[0] * sine, 1.0L};
  const SlantReal from = p.axis + p.lens_offset, start = w + climb;
  out.in_print = {from * cosine + start * sine, start * cosine - from * sine, s.focal_length};
  return out;
}

}  // namespace lentray::test
