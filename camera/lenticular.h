// The lenticular camera: the sheet placed in the world. World space, unit directions.
//
// Through row height Y the ray of a column runs along v = tan t r + d + (Y/V + eye_slope_y) u and
// passes through C + x_i s r + Y u (s: scene units a millimetre); it starts lens_front scene units
// before the sheet, measured along d, so objects in front of the sheet are recorded too.
// With a finite V the sheet has no power vertically, so there the eye's own perspective holds.
// With an eye of the scene's (camera/scene_eye.h) V is the viewer's alone: tan t becomes the slope towards
// that eye, and D takes the place of V in the rows.
// Everything that depends on the column alone lies in a table.
// Source: docs/lens/formulae.md; Snell's law (camera/lens_sheet.h).
#pragma once

#include <vector>

#include "camera/camera_of_others.h"
#include "camera/lens_sheet.h"
#include "camera/scene_eye.h"
#include "core/base/vec3.h"

namespace lentray::camera {

/// The sheet in the world. Axes unit, right perpendicular to up, normal perpendicular to both.
struct SheetPlacement {
  core::Vec3 centre;
  core::Vec3 right{1.0, 0.0, 0.0};
  core::Vec3 up{0.0, 1.0, 0.0};
  core::Vec3 normal{0.0, 0.0, 1.0};  ///< d, from the viewer into the display
  double width = 1.0, height = 1.0;  ///< scene units
  /// Slopes of the line eye - sheet's middle: -e_x/V, -e_y/V for an eye whose foot is (e_x, e_y). Of the
  /// scene's eye, if there is one; the viewer is before the sheet's middle then.
  double eye_slope_x = 0.0, eye_slope_y = 0.0;
  std::optional<SceneEye> eye{};  ///< empty: the viewer's own eye sees the scene
  double front = 0.0;             ///< lens_front, scene units
  double height_mm = 0.0;         ///< of the sheet; 0: as high to its width as in the scene
};

class Lenticular : public Camera {
 public:
  /// lens_front beyond the eye is clamped to it.
  Lenticular(const LensParameters& lens, const SheetPlacement& placement, std::uint32_t width,
             std::uint32_t height);
  bool ray(double column, double row, core::Ray& ray) const override;
  /// A pixel's area is its lens's width, across which its direction goes on as that of lenses in
  /// between would: with V infinite it stays, with V finite the rays of a view meet at its eye.
  bool ray_at(const core::PixelPlace& place, core::Ray& out) const override;
  /// From the sheet's plane, one scene unit of its normal long.
  bool sight(const core::PixelPlace& place, core::Ray& out) const override;
  core::EyePlace eye_place(std::uint32_t column, std::uint32_t row) const override;
  core::PixelLattice lattice(std::uint32_t width) const override;
  Properties describe() const override;

  const LensSheet& sheet() const { return m_sheet; }
  const SheetPlacement& placement() const { return m_place; }
  /// s: scene units a millimetre.
  double scale() const { return m_scale; }
  /// How far before the sheet the eye is that sees the scene: V or D, in scene units; infinite as it may be.
  double eye_distance() const { return 1.0 / m_inverse_distance; }
  /// Rays are not parallel.
  bool has_near_eye() const { return m_inverse_distance != 0.0; }
  /// The part of the true depth that is shown, near the sheet's plane.
  double depth_factor() const {
    return m_place.eye ? m_place.eye->factor : m_sheet.lens().depth_factor;
  }
  /// The way of the viewer's eye along the sheet, in mm, and that of the scene's eye, in scene units: their ratio.
  /// With V infinite 0.
  double eye_scale() const {
    return m_place.eye ? m_place.eye->factor * eye_distance() / m_sheet.lens().view_distance
                       : m_scale;
  }
  /// Of the column's ray, through its lens's vertex: along right, towards its eye.
  double scene_slope(const LensColumn& c) const {
    return m_slopes.of(c.axis, c.slope) + shift_of_slope();
  }
  /// Height Y of a place in the image's rows, scene units from the sheet's middle.
  double row_height(double row) const { return (0.5 - row / height()) * m_place.height; }
  /// The slope of a row's rays along up: Y/V + eye_slope_y, Y/D of the scene's eye.
  double rise(double row) const {
    return row_height(row) * m_inverse_distance + m_place.eye_slope_y;
  }
  /// The same of the light that the row sends to the viewer.
  double viewers_rise(double row) const {
    return m_place.eye ? row_height(row) / (m_sheet.lens().view_distance * m_scale) : rise(row);
  }
  /// The pixel that view j of `views` shows at a place of its picture of one pixel a lens.
  virtual core::PixelPlace strip_place(std::uint32_t view, std::uint32_t views,
                                       const core::PixelPlace& place) const;
  /// The place whose lens's axis passes `at`, in lenses along a row from the sheet's left edge, at a
  /// place in the image's rows. It has the print offset `cell`, in cells from the cell's middle.
  virtual core::PixelPlace place_at(double at, double row, double cell) const;

  /// Pixels that show nothing.
  virtual std::uint64_t dark_pixels() const {
    return std::uint64_t{m_sheet.dark_columns()} * height();
  }
  double sheet_height() const;  ///< mm
  /// The print's size in mm, and its resolution in pixels an inch both ways.
  double print_width() const { return m_sheet.print_width(); }
  double print_height() const;
  double print_dpi_x() const { return m_sheet.lens().print_dpi(); }
  double print_dpi_y() const { return height() * 25.4 / print_height(); }
  /// What a user should know: clamped front, dark pixels.
  std::vector<std::string> warnings() const;
  /// Lines of the report about the lens model.
  virtual std::vector<std::string> model_report() const;

 protected:
  /// sight() by ray_at(), which starts lens_front before the sheet.
  bool sight_of_ray(const core::PixelPlace& place, core::Ray& out) const;
  /// What a user should know of dark pixels, of which there are some.
  virtual std::string dark_warning() const;
  const SceneSlopes& slopes() const { return m_slopes; }
  /// What the place of the scene's eye adds to all slopes along right.
  double shift_of_slope() const { return m_place.eye ? m_place.eye_slope_x : 0.0; }

 private:
  struct Column {
    core::Vec3 axis;   ///< C + x_i s r
    core::Vec3 slope;  ///< tan t r + d + eye_slope_y u
    core::Vec3 start;  ///< V infinite: axis - front slope
    core::Vec3 unit;   ///< V infinite: slope, unit
    std::int64_t lens = 0,
                 view = 0;  ///< of a pixel's column: views count from the lens's left edge
    bool dark = false;
  };
  Column make_column(const LensColumn& c) const;
  Column column_at(const core::PixelPlace& place) const;
  bool aim(const Column& c, double row, core::Ray& ray) const;

  LensSheet m_sheet;
  SheetPlacement m_place;
  double m_scale;
  double m_inverse_distance;  ///< 1/V or 1/D in scene units, 0: infinite
  SceneSlopes m_slopes;
  bool m_clamped = false;
  std::vector<Column> m_columns;
};

/// The column that view j of `views` has behind a lens, of the sheet or beyond its edges: the one
/// that holds the print offset ((j + 1/2)/views - 1/2) P', or, where the lens does not own that
/// one, the lens's own beside it. With whole N and as many views it is i N + j.
std::int64_t view_column(double lens_pixels, std::uint32_t view, std::uint32_t views,
                         std::int64_t lens);
/// N if it is whole, else floor(N).
std::uint32_t usual_views(const LensSheet& sheet);
/// Lenses that have the view: all, but perhaps a last one that is cut.
std::uint32_t view_width(const LensSheet& sheet, std::uint32_t view, std::uint32_t views);

/// One view of a sheet, of usual_views(): pixel i is what lens i shows in view j, at its own column
/// (view_column()).
class SheetView final : public CameraOfOthers {
 public:
  /// The sheet must outlive the view and must have it: j < usual_views(), and view_width() above 0.
  SheetView(const Lenticular& lenticular, std::uint32_t view);

  bool ray(double column, double row, core::Ray& ray) const override;
  Properties describe() const override;

 private:
  Found find(const core::PixelPlace& place) const override {
    return {m_lenticular, m_lenticular.strip_place(m_view, m_views, place)};
  }

  const Lenticular& m_lenticular;
  std::uint32_t m_view, m_views;
};

}  // namespace lentray::camera
