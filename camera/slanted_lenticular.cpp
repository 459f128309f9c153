#include "camera/slanted_lenticular.h"

#include <algorithm>
#include <cmath>

#include "camera/text.h"

namespace lentray::camera {
namespace {

SlantedPrint print_of(const Lenticular& sheet, double stretch) {
  const SheetPlacement& place = sheet.placement();
  if (place.eye) return {sheet.width(), sheet.height(), sheet.sheet_height(), 0.0, 0.0};
  return {sheet.width(), sheet.height(), sheet.sheet_height(), place.eye_slope_x,
          place.eye_slope_y / stretch};
}

double stretch_of(const Lenticular& sheet) {
  const SheetPlacement& place = sheet.placement();
  return place.height_mm > 0.0 ? place.height / place.height_mm / sheet.scale() : 1.0;
}

}  // namespace

SlantedLenticular::SlantedLenticular(const LensParameters& lens, const SheetPlacement& placement,
                                     std::uint32_t width, std::uint32_t height)
    : Lenticular(lens, placement, width, height), m_stretch(stretch_of(*this)),
      m_rows(lens, print_of(*this, m_stretch)) {
  if (lens.model == LensModel::kThick) m_lens.emplace(lens);
  m_shares = count_shares();
  m_dark_pixels = count_dark_pixels();
}

SlantedPlace SlantedLenticular::on_print(const core::PixelPlace& place) const {
  return m_rows.place(place.column + 0.5 + place.turn, place.row + 0.5,
                      m_rows.lens_of(place.column, place.row), place.across);
}

bool SlantedLenticular::exit_of(const SlantedPlace& at, double row, SheetExit& out) const {
  out = {};
  return m_rows.slope_across(at.lens_offset, m_rows.along(m_rows.rise(row)), out.slope);
}

double SlantedLenticular::scene_slope(const SlantedPlace& at, const SheetExit& exit,
                                      double row) const {
  const double light = m_rows.slope_x(exit.slope, m_rows.rise(row));
  if (!placement().eye) return light;
  const double height = m_rows.row_height(row);
  SheetExit vertex;
  const double middle =
      exit_of(at, row, vertex) ? m_rows.slope_x(vertex.slope, m_rows.rise(row)) : light;
  return slopes().of(m_rows.x_of(at.axis + exit.across, height), light,
                     m_rows.x_of(at.axis, height), middle) +
         shift_of_slope();
}

void SlantedLenticular::place_ray(const SlantedPlace& at, const SheetExit& exit, double row,
                                  core::Ray& out) const {
  const SheetPlacement& p = placement();
  const double x = m_rows.x_of(at.axis + exit.across, m_rows.row_height(row));
  const core::Vec3 v = p.right * scene_slope(at, exit, row) + p.normal + p.up * rise(row);
  const double depth = exit.depth * scale();
  const core::Vec3 leaves =
      p.centre + p.right * (x * scale()) + p.normal * depth + p.up * Lenticular::row_height(row);
  out.origin = leaves - v * (p.front + depth);
  out.direction = core::normalized(v);
}

bool SlantedLenticular::ray(double column, double row, core::Ray& ray) const {
  core::PixelPlace place;
  place.column = static_cast<std::int32_t>(std::clamp(std::floor(column), 0.0, width() - 1.0));
  place.row = static_cast<std::int32_t>(std::clamp(std::floor(row), 0.0, height() - 1.0));
  // Between centres a place stays under the lens its pixel belongs to.
  place.turn = column - place.column - 0.5;
  place.down = row - place.row - 0.5;
  return ray_at(place, ray);
}

bool SlantedLenticular::ray_at(const core::PixelPlace& place, core::Ray& out) const {
  const SlantedPlace at = on_print(place);
  const double row = place.row + 0.5 + place.down;
  SheetExit exit;
  if (!exit_of(at, row, exit)) return false;
  place_ray(at, exit, row, out);
  return true;
}

bool SlantedLenticular::one_ray_at(const core::PixelPlace& place, const core::PlaceRay& which,
                                   core::Ray& out) const {
  if (!m_lens) return ray_at(place, out);
  const SlantedPlace at = on_print(place);
  const double row = place.row + 0.5 + place.down + which.through.down;
  SheetExit exit;
  const SlopeAlong along = m_rows.along(m_rows.rise(row));
  const double across = m_lens->at_part(which.through.across);
  if (!shows(m_lens->leave(at.lens_offset, across, along, exit))) return false;
  place_ray(at, exit, row, out);
  return true;
}

core::EyePlace SlantedLenticular::eye_place(std::uint32_t column, std::uint32_t row) const {
  const auto at = static_cast<std::int32_t>(row);
  return {m_rows.lens_of(column, at), row, m_rows.view_of(column, at)};
}

core::PixelLattice SlantedLenticular::lattice(std::uint32_t columns) const {
  const auto step = static_cast<std::uint32_t>(std::floor(sheet().lens().pixels + 0.5));
  core::PixelLattice out;
  out.step = 0;
  out.left.resize(columns);
  for (std::uint32_t k = 0; k < columns; ++k) {
    out.left[k] = static_cast<std::int32_t>(k) - static_cast<std::int32_t>(step);
    if (k % (step * core::PixelLattice::kTile) == 0) out.tiles.push_back(k);
  }
  out.tiles.push_back(columns);
  return out;
}

core::PixelPlace SlantedLenticular::strip_place(std::uint32_t view, std::uint32_t views,
                                                const core::PixelPlace& place) const {
  core::PixelPlace out = place;
  out.column = static_cast<std::int32_t>(m_rows.view_column(view, views, place.column, place.row));
  return out;
}

core::PixelPlace SlantedLenticular::place_at(double at, double row, double cell) const {
  const double pixels = sheet().lens().pixels;
  core::PixelPlace out;
  out.row = static_cast<std::int32_t>(std::floor(row));
  out.down = row - out.row - 0.5;
  const double lens = at - 0.5 - m_rows.shift(row) / pixels;  // that stands there
  const double own = std::floor(lens + 0.5);
  const double middle = (own + 0.5) * pixels + m_rows.shift(out.row + 0.5);
  out.column = static_cast<std::int32_t>(std::floor(middle));
  // Of lenses as narrow as a pixel, another one may own it.
  const auto owner = static_cast<double>(m_rows.lens_of(out.column, out.row));
  out.across = lens - owner;
  out.turn = (owner + 0.5 + cell) * pixels + m_rows.shift(out.row + 0.5) - out.column - 0.5;
  return out;
}

bool SlantedLenticular::is_dark(std::uint32_t column, std::uint32_t row) const {
  const SlantedPlace at = on_print(
      {.column = static_cast<std::int32_t>(column), .row = static_cast<std::int32_t>(row)});
  SheetExit exit;
  if (!m_lens) return !exit_of(at, row + 0.5, exit);
  return m_lens->is_dark(at.lens_offset, m_rows.along(m_rows.rise(row + 0.5)));
}

bool SlantedLenticular::may_be_dark() const {
  if (sheet().lens().model == LensModel::kParaxial) return false;
  // The more a ray rises and the farther its pixel lies aside, the more it bends. If the most do leave
  // their lens in every corner of the sheet, all do.
  const double edge = 0.5 * sheet().lens().print_pitch();
  const double last_row = height() - 0.5;
  for (const std::uint32_t column : {0u, width() - 1}) {
    for (const double row : {0.5, last_row}) {
      const std::int64_t lens = m_rows.lens_of(column, static_cast<std::int32_t>(std::floor(row)));
      const double middle = m_rows.offset_of_cell(m_rows.axis_of(static_cast<double>(lens)));
      for (const double rise : {m_rows.rise(0.5), m_rows.rise(last_row), 0.0}) {
        for (const double offset : {middle - edge, middle + edge}) {
          SheetExit exit;
          const SlopeAlong along = m_rows.along(rise);
          const bool leaves = m_lens ? m_lens->leave(offset, m_lens->middle(m_lens->rays() / 2),
                                                     along, exit) == LensRayEnd::kLeaves
                                     : m_rows.slope_across(offset, along, exit.slope);
          if (!leaves) return true;
        }
      }
    }
  }
  return false;
}

std::uint64_t SlantedLenticular::count_dark_pixels() const {
  if (!may_be_dark()) return 0;
  std::uint64_t dark = 0;
  for (std::uint32_t row = 0; row < height(); ++row) {
    for (std::uint32_t k = 0; k < width(); ++k) dark += is_dark(k, row) ? 1 : 0;
  }
  return dark;
}

RayShares SlantedLenticular::count_shares() const {
  if (!m_lens) return {};
  const std::uint32_t row = height() / 2;
  const SlopeAlong along = m_rows.along(m_rows.rise(row + 0.5));
  RayShares shares;
  for (std::uint32_t k = 0; k < width(); ++k) {
    const core::PixelPlace place{.column = static_cast<std::int32_t>(k),
                                 .row = static_cast<std::int32_t>(row)};
    shares.add(*m_lens, on_print(place).lens_offset, along);
  }
  return shares.of(static_cast<double>(width()) * m_lens->rays());
}

std::string SlantedLenticular::dark_warning() const {
  return std::to_string(m_dark_pixels) +
         " pixels show nothing, for their light does not leave the sheet: it is totally reflected "
         "inside it, or comes back to the print";
}

std::vector<std::string> SlantedLenticular::model_report() const {
  std::vector<std::string> out = Lenticular::model_report();
  out.push_back("The lenses are slanted by " + brief(slant_degrees(sheet().lens())) +
                " degrees, a tangent of " + brief(sheet().lens().slant) +
                ": their tops lean to the " + (sheet().lens().slant > 0.0 ? "right" : "left") +
                "; the pitch is measured across them, pixels a lens along a row");
  if (m_lens) out.push_back(m_shares.line(m_lens->rays()));
  return out;
}

Properties SlantedLenticular::describe() const {
  Properties out = Lenticular::describe();
  out.emplace_back("lens.slant_deg", slant_degrees(sheet().lens()));
  if (m_lens) m_shares.describe(m_lens->rays(), out);
  return out;
}

}  // namespace lentray::camera
