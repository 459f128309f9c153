#include "camera/lenticular.h"

#include <algorithm>
#include <cmath>

#include "camera/text.h"

namespace lentray::camera {

namespace {

/// The eye's slope across the lenses.
double across_lenses(const LensParameters& lens, const SheetPlacement& place) {
  if (place.eye) return 0.0;
  if (lens.slant == 0.0) return place.eye_slope_x;
  return (place.eye_slope_x - place.eye_slope_y * lens.slant) * lens.slant_cosine();
}

}  // namespace

Lenticular::Lenticular(const LensParameters& lens, const SheetPlacement& placement,
                       std::uint32_t width, std::uint32_t height)
    : Camera("lenticular", width, height), m_sheet(lens, width, across_lenses(lens, placement)),
      m_place(placement), m_scale(placement.width / m_sheet.sheet_width()),
      m_inverse_distance(1.0 /
                         (placement.eye ? placement.eye->distance : lens.view_distance * m_scale)) {
  if (m_place.eye) {
    m_slopes =
        SceneSlopes(lens.view_distance, m_place.eye->distance / m_scale, m_place.eye->factor);
  }
  if (m_place.front * m_inverse_distance > 1.0) {
    m_clamped = m_place.front * m_inverse_distance > 1.0 + 1e-9;  // more than rounding
    m_place.front = eye_distance();
  }
  m_columns.reserve(width);
  for (std::uint32_t k = 0; k < width; ++k) {
    const std::int64_t of = m_sheet.lens_of(k);
    m_columns.push_back(make_column(m_sheet.column(k)));
    m_columns.back().lens = of;
    m_columns.back().view = k - core::LensColumns{lens.pixels}.first_column(of);
  }
}

Lenticular::Column Lenticular::make_column(const LensColumn& c) const {
  Column out;
  out.dark = c.dark;
  out.axis = m_place.centre + m_place.right * (c.axis * m_scale);
  out.slope = m_place.right * scene_slope(c) + m_place.normal + m_place.up * m_place.eye_slope_y;
  if (has_near_eye()) return out;
  out.start = out.axis - out.slope * m_place.front;
  out.unit = core::normalized(out.slope);
  return out;
}

bool Lenticular::aim(const Column& c, double row, core::Ray& ray) const {
  if (c.dark) return false;
  const double y = row_height(row);
  if (m_inverse_distance == 0.0) {
    ray.origin = c.start + m_place.up * y;
    ray.direction = c.unit;
    return true;
  }
  const core::Vec3 v = c.slope + m_place.up * (y * m_inverse_distance);
  ray.origin = c.axis + m_place.up * y - v * m_place.front;
  ray.direction = core::normalized(v);
  return true;
}

bool Lenticular::ray(double column, double row, core::Ray& ray) const {
  const double last = static_cast<double>(m_columns.size() - 1);
  const double whole = std::clamp(std::floor(column), 0.0, last);
  const auto k = static_cast<std::uint32_t>(whole);
  if (column == whole + 0.5) return aim(m_columns[k], row, ray);
  // Between centres a place stays under the lens its pixel belongs to.
  return aim(make_column(m_sheet.place(column, m_sheet.lens_of(k))), row, ray);
}

bool Lenticular::ray_at(const core::PixelPlace& place, core::Ray& out) const {
  const double row = place.row + 0.5 + place.down;
  const bool is_inside =
      place.column >= 0 && static_cast<std::size_t>(place.column) < m_columns.size();
  if (is_inside && place.across == 0.0 && place.turn == 0.0) {
    return aim(m_columns[static_cast<std::size_t>(place.column)], row, out);
  }
  return aim(column_at(place), row, out);
}

Lenticular::Column Lenticular::column_at(const core::PixelPlace& place) const {
  return make_column(m_sheet.beside(place.column, place.across, place.turn));
}

bool Lenticular::sight(const core::PixelPlace& place, core::Ray& out) const {
  const Column c = column_at(place);
  if (c.dark) return false;
  const double y = row_height(place.row + 0.5 + place.down);
  out = {c.axis + m_place.up * y, c.slope + m_place.up * (y * m_inverse_distance)};
  return true;
}

bool Lenticular::sight_of_ray(const core::PixelPlace& place, core::Ray& out) const {
  if (!ray_at(place, out)) return false;
  out.direction = out.direction / core::dot(out.direction, m_place.normal);
  out.origin += out.direction * m_place.front;
  return true;
}

core::PixelPlace Lenticular::strip_place(std::uint32_t view, std::uint32_t views,
                                         const core::PixelPlace& place) const {
  core::PixelPlace out = place;
  out.column =
      static_cast<std::int32_t>(view_column(m_sheet.lens().pixels, view, views, place.column));
  return out;
}

core::PixelPlace Lenticular::place_at(double at, double row, double cell) const {
  const double pixels = m_sheet.lens().pixels;
  // The axis of lens i is at i + 1/2.
  const double lens =
      std::clamp(std::floor(at), 0.0, static_cast<double>(m_sheet.lens_count() - 1));
  const auto first =
      static_cast<double>(core::LensColumns{pixels}.first_column(static_cast<std::int64_t>(lens)));
  core::PixelPlace out;
  out.column = static_cast<std::int32_t>(first);
  out.across = at - 0.5 - lens;
  out.turn = (lens + 0.5 + cell) * pixels - first - 0.5;
  out.row = static_cast<std::int32_t>(std::floor(row));
  out.down = row - out.row - 0.5;
  return out;
}

core::EyePlace Lenticular::eye_place(std::uint32_t column, std::uint32_t row) const {
  // Corners of pixels lie a column beyond the last.
  const Column& c = m_columns[std::min<std::size_t>(column, m_columns.size() - 1)];
  return {c.lens, row, c.view};
}

core::PixelLattice Lenticular::lattice(std::uint32_t width) const {
  core::PixelLattice out;
  out.step = m_sheet.views();
  out.left.resize(width);
  for (std::uint32_t k = 0; k < width; ++k) {
    out.left[k] = static_cast<std::int32_t>(m_sheet.left_of(k));
    const std::int64_t lens = m_sheet.lens_of(k);
    if (lens % core::PixelLattice::kTile == 0 && (k == 0 || m_sheet.lens_of(k - 1) != lens)) {
      out.tiles.push_back(k);
    }
  }
  out.tiles.push_back(width);
  return out;
}

double Lenticular::sheet_height() const {
  return m_place.height_mm > 0.0 ? m_place.height_mm : m_place.height / m_scale;
}

double Lenticular::print_height() const {
  const LensParameters& lens = m_sheet.lens();
  return sheet_height() * (lens.print_pitch() / lens.pitch);
}

std::vector<std::string> Lenticular::warnings() const {
  std::vector<std::string> out;
  if (m_clamped) {
    out.push_back(
        "lens_front reaches beyond the eye, where the rays cross: it is set to the viewing "
        "distance, " +
        format(m_place.front) + " scene units");
  }
  if (dark_pixels() > 0) out.push_back(dark_warning());
  return out;
}

std::string Lenticular::dark_warning() const {
  return std::to_string(dark_pixels()) + " pixels (" + std::to_string(m_sheet.dark_columns()) +
         " columns) show nothing, for their light is totally reflected inside the sheet; "
         "the widest usable lens pitch is " +
         format(m_sheet.widest_pitch()) + " mm";
}

std::vector<std::string> Lenticular::model_report() const {
  const LensParameters& lens = m_sheet.lens();
  if (!lens.is_finite() || lens.model == LensModel::kParaxial) return {};
  return {"Rays miss the eyes of their views by at most " + format(m_sheet.largest_eye_miss()) +
          " pixels (Snell's law)"};
}

Properties Lenticular::describe() const {
  const LensParameters& lens = m_sheet.lens();
  const core::Vec3 slopes(m_place.eye_slope_x, m_place.eye_slope_y, 0.0);
  Properties out{{"camera", std::string("lenticular")},
                 {"lens.pitch_mm", lens.pitch},
                 {"lens.focal_length_mm", lens.focal_length},
                 {"lens.ior", lens.ior},
                 {"lens.pixels", lens.pixels},
                 {"lens.view_distance_mm", lens.is_finite() ? lens.view_distance : 0.0},
                 {"lens.model", std::string(name_of(lens.model))},
                 {"lens.paraxial_error_px", m_sheet.paraxial_error()},
                 {"lens.eye_miss_px", m_sheet.largest_eye_miss()},
                 {"lens.print_pitch_mm", lens.print_pitch()},
                 {"lens.lpi", lens.lenses_per_inch()},
                 {"lens.lenses", m_sheet.lenses()},
                 {"lens.views", static_cast<double>(m_sheet.views())},
                 {"lens.sheet_width_mm", m_sheet.sheet_width()},
                 {"lens.sheet_height_mm", sheet_height()},
                 {"lens.print_width_mm", print_width()},
                 {"lens.print_height_mm", print_height()},
                 {"lens.print_dpi_x", print_dpi_x()},
                 {"lens.print_dpi_y", print_dpi_y()},
                 {"lens.depth_factor", depth_factor()},
                 {"lens.scene_units_per_mm", m_scale},
                 {"lens.front", m_place.front},
                 {"lens.centre", m_place.centre},
                 {"lens.right", m_place.right * m_place.width},
                 {"lens.up", m_place.up * m_place.height},
                 {"lens.direction", m_place.normal},
                 {"lens.eye_slope", m_place.eye ? core::Vec3() : slopes},
                 {"lens.dark_pixels", static_cast<double>(dark_pixels())}};
  if (m_place.eye) {
    out.emplace_back("lens.scene_distance", has_near_eye() ? eye_distance() : 0.0);
    out.emplace_back("lens.scene_eye_slope", slopes);
  }
  return out;
}

std::int64_t view_column(double lens_pixels, std::uint32_t view, std::uint32_t views,
                         std::int64_t lens) {
  const auto i = static_cast<double>(lens);
  if (lens_pixels == views) return lens * views + view;
  const auto column =
      static_cast<std::int64_t>(std::floor(lens_pixels * (i + (view + 0.5) / views)));
  const std::int64_t owner = core::LensColumns{lens_pixels}.lens_of(column);
  return owner < lens ? column + 1 : owner > lens ? column - 1 : column;
}

std::uint32_t usual_views(const LensSheet& sheet) {
  return static_cast<std::uint32_t>(std::floor(sheet.lens().pixels));
}

std::uint32_t view_width(const LensSheet& sheet, std::uint32_t view, std::uint32_t views) {
  if (sheet.is_slanted()) {
    return std::max(1u, static_cast<std::uint32_t>(std::floor(sheet.lenses() + 0.5)));
  }
  const std::uint32_t last = sheet.lens_count() - 1;
  return last + (view_column(sheet.lens().pixels, view, views, last) < sheet.width() ? 1 : 0);
}

SheetView::SheetView(const Lenticular& lenticular, std::uint32_t view)
    : CameraOfOthers(lenticular, lenticular.name(),
                     view_width(lenticular.sheet(), view, usual_views(lenticular.sheet())),
                     lenticular.height()),
      m_lenticular(lenticular), m_view(view), m_views(usual_views(lenticular.sheet())) {}

bool SheetView::ray(double column, double row, core::Ray& ray) const {
  if (m_lenticular.sheet().is_slanted()) {
    return ray_at({.column = static_cast<std::int32_t>(std::floor(column)),
                   .row = static_cast<std::int32_t>(std::floor(row))},
                  ray);
  }
  const double last = static_cast<double>(width() - 1);
  const double lens = std::clamp(std::floor(column), 0.0, last);
  // Within a pixel the view's picture runs across the lens's N pixels' worth of sheet; only the
  // centre is a ray of the sheet, so finer places fall on it.
  const std::int64_t k = view_column(m_lenticular.sheet().lens().pixels, m_view, m_views,
                                     static_cast<std::int64_t>(lens));
  return m_lenticular.ray(static_cast<double>(k) + 0.5, row, ray);
}

Properties SheetView::describe() const {
  Properties out = m_lenticular.describe();
  out.emplace_back("lens.view", static_cast<double>(m_view));
  out.emplace_back("lens.view_count", static_cast<double>(m_views));
  return out;
}

}  // namespace lentray::camera
