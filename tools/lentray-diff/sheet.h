// The lens sheet of a picture, as lentray reports it in its statistics file ("lens.*"), and the
// rays that follow from it. The formulae stand here a second time, on purpose: a mistake in the
// renderer must not reach the reference that is to show it.
//
// Space: world. Lens data in mm, the rest in scene units. For pixel column k of lens i:
//   o = e + x_i f/(nV) + print shift, tan t = n o/f (paraxial) or sin t = n sin atan(o/f),
//   v = tan t r + d + (Y/V + eye_slope_y) u through C + x_i r + Y u.
// With an eye of the scene's, D before the sheet, tan t becomes m tan t + x_i (1/D - m/V) + eye_slope_x (D in mm there), and
// rows have D for V.
// A place off the pixel's centre has another x_i (across), Y (down) or e (turn).
// Errors: std::runtime_error that names a key that is missing or wrong. Immutable once made.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "core/base/vec3.h"

namespace lentray::diff {

/// A place in the area of a pixel and in the directions it covers, each -0.5 to 0.5 off the centre.
struct PixelOffset {
  double across = 0.0;  ///< to the right, in lenses: under a lens with the same print behind it
  double down = 0.0;    ///< in rows
  double turn = 0.0;    ///< to the right in the print, in pixels
};

struct Sheet {
  core::Vec3 centre;                                           ///< C
  core::Vec3 right{1, 0, 0}, up{0, 1, 0}, direction{0, 0, 1};  ///< unit r, u, d
  double width = 1.0, height = 1.0;                            ///< |right|, |up|, scene units
  double eye_slope_x = 0.0, eye_slope_y = 0.0;                 ///< -e_x/V, -e_y/V of the eye's foot
  double front = 0.0;                                          ///< lens_front, scene units
  double pitch = 1.124, focal_length = 3.03, ior = 1.6, pixels = 15.0;
  double view_distance = 0.0;  ///< V, mm; infinite: infinity
  /// Of offsets in a cell, before the model asks where they look; with an eye of the scene's m.
  double depth_factor = 1.0;
  /// D, scene units; infinite: parallel rays. Empty: the viewer's eye sees the scene.
  std::optional<double> scene_distance{};
  bool paraxial = false;
  bool turned_views = false;  ///< the sheet is on its side, its views' pictures are upright
  std::uint32_t columns = 0, rows = 0;  ///< the integral image, W x H

  bool is_finite() const;
  /// Of the eye that sees the scene, from the sheet; infinite: parallel rays. Scene units.
  double eye_distance() const { return scene_distance.value_or(view_distance * scale()); }
  bool has_views() const;  ///< N is whole
  std::uint32_t views() const;
  double lenses() const { return columns / pixels; }           ///< L, fractional if cut
  double print_pitch() const;                                  ///< P'
  double scale() const { return width / (lenses() * pitch); }  ///< s, scene units per mm
  std::uint32_t lens_of(std::uint32_t column) const;
  double axis(double lens) const { return (lens + 0.5 - lenses() / 2.0) * pitch; }
  double row_height(std::uint32_t row) const { return (0.5 - (row + 0.5) / rows) * height; }
  /// e_j of view j, mm: the same for every lens; times the depth factor or m.
  double cell_offset(std::uint32_t view) const;
  /// What the print is moved to the side for an eye that is not before the middle, mm: f/n
  /// eye_slope_x; with V infinite, what the model sees along eye_slope_x.
  double print_shift() const;
  /// tan t; nothing on total internal reflection.
  std::optional<double> slope(std::uint32_t column, const PixelOffset& offset = {}) const;
  /// Lenses that have view j.
  std::uint32_t view_width(std::uint32_t view) const;
  /// The same sheet with every pixel cut into `parts` columns.
  Sheet finer(int parts) const;
};

/// From the statistics of lentray. Nothing if the picture is no integral image.
std::optional<Sheet> sheet_of(const nlohmann::json& statistics);

}  // namespace lentray::diff
