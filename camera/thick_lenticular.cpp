#include "camera/thick_lenticular.h"

#include <algorithm>
#include <cmath>

#include "camera/text.h"

namespace lentray::camera {

ThickLenticular::ThickLenticular(const LensParameters& lens, const SheetPlacement& placement,
                                 std::uint32_t width, std::uint32_t height)
    : Lenticular(lens, placement, width, height), m_lens(lens), m_shares(count_shares()),
      m_dark_pixels(count_dark_pixels()) {}

LensColumn ThickLenticular::column_at(const core::PixelPlace& place) const {
  const bool is_inside =
      place.column >= 0 && static_cast<std::uint32_t>(place.column) < sheet().width();
  if (is_inside && place.across == 0.0 && place.turn == 0.0) {
    return sheet().column(static_cast<std::uint32_t>(place.column));
  }
  return sheet().beside(place.column, place.across, place.turn);
}

void ThickLenticular::place_ray(const LensColumn& column, const SheetExit& exit, double row,
                                core::Ray& out) const {
  const SheetPlacement& p = placement();
  const double slope =
      slopes().of(column.axis + exit.across, exit.slope, column.axis, column.slope);
  const core::Vec3 v = p.right * (slope + shift_of_slope()) + p.normal + p.up * rise(row);
  const core::Vec3 leaves = p.centre + p.right * ((column.axis + exit.across) * scale()) +
                            p.normal * (exit.depth * scale()) + p.up * row_height(row);
  out.origin = leaves - v * (p.front + exit.depth * scale());
  out.direction = core::normalized(v);
}

bool ThickLenticular::through_vertex(const LensColumn& column, double row, core::Ray& out) const {
  SheetExit exit;
  if (!shows(m_lens.leave(column.lens_offset, 0.0, {viewers_rise(row)}, exit))) return false;
  place_ray(column, exit, row, out);
  return true;
}

bool ThickLenticular::ray(double column, double row, core::Ray& ray) const {
  const double last = static_cast<double>(sheet().width() - 1);
  const double whole = std::clamp(std::floor(column), 0.0, last);
  const auto k = static_cast<std::uint32_t>(whole);
  if (column == whole + 0.5) return through_vertex(sheet().column(k), row, ray);
  // Between centres a place stays under the lens its pixel belongs to.
  return through_vertex(sheet().place(column, sheet().lens_of(k)), row, ray);
}

bool ThickLenticular::ray_at(const core::PixelPlace& place, core::Ray& out) const {
  return through_vertex(column_at(place), place.row + 0.5 + place.down, out);
}

bool ThickLenticular::one_ray_at(const core::PixelPlace& place, const core::PlaceRay& which,
                                 core::Ray& out) const {
  const LensColumn column = column_at(place);
  const double row = place.row + 0.5 + place.down + which.through.down;
  const double across = m_lens.at_part(which.through.across);
  SheetExit exit;
  if (!shows(m_lens.leave(column.lens_offset, across, {viewers_rise(row)}, exit))) return false;
  place_ray(column, exit, row, out);
  return true;
}

RayShares ThickLenticular::count_shares() const {
  constexpr std::uint64_t kMostRays = std::uint64_t{1} << 20;
  const std::uint64_t rays = std::uint64_t{sheet().width()} * m_lens.rays();
  const std::uint64_t step = rays / kMostRays + 1;  // of columns: whole sheets but for huge ones
  const double rise_there = viewers_rise(0.5 * height());
  RayShares shares;
  std::uint64_t columns = 0;
  for (std::uint64_t k = 0; k < sheet().width(); k += step) {
    shares.add(m_lens, sheet().column(static_cast<std::uint32_t>(k)).lens_offset,
               {rise_there, 0.0});
    ++columns;
  }
  return shares.of(static_cast<double>(columns) * m_lens.rays());
}

bool ThickLenticular::is_never_dark(const LensColumn& column) const {
  // The more a ray rises, the more it bends. One that leaves straight from its lens with the least
  // and with the most rise does so with all between.
  const double first = viewers_rise(0.5), last = viewers_rise(height() - 0.5);
  const double most = std::max(std::fabs(first), std::fabs(last));
  const double least = first * last <= 0.0 ? 0.0 : std::min(std::fabs(first), std::fabs(last));
  for (std::uint32_t j = 0; j < m_lens.rays(); ++j) {
    const double across = m_lens.middle(j);
    SheetExit exit;
    if (m_lens.leave(column.lens_offset, across, {most}, exit) == LensRayEnd::kLeaves &&
        m_lens.leave(column.lens_offset, across, {least}, exit) == LensRayEnd::kLeaves) {
      return true;
    }
  }
  return false;
}

std::uint64_t ThickLenticular::count_dark_pixels() const {
  std::uint64_t dark = 0;
  for (std::uint32_t k = 0; k < sheet().width(); ++k) {
    const LensColumn& column = sheet().column(k);
    if (is_never_dark(column)) continue;
    if (!sheet().lens().is_finite()) {
      if (m_lens.is_dark(column.lens_offset, {viewers_rise(0.5), 0.0})) dark += height();
      continue;
    }
    for (std::uint32_t row = 0; row < height(); ++row) {
      if (m_lens.is_dark(column.lens_offset, {viewers_rise(row + 0.5), 0.0})) ++dark;
    }
  }
  return dark;
}

std::string ThickLenticular::dark_warning() const {
  return std::to_string(m_dark_pixels) +
         " pixels show nothing, for none of their rays leaves the sheet: they are totally "
         "reflected "
         "inside it, or come back to the print";
}

void RayShares::add(const ThickLens& lens, double offset, const SlopeAlong& along) {
  for (std::uint32_t j = 0; j < lens.rays(); ++j) {
    SheetExit exit;
    const LensRayEnd end = lens.leave(offset, lens.middle(j), along, exit);
    if (end == LensRayEnd::kSpills || end == LensRayEnd::kReturns) ++spilled;
    if (!shows(end)) ++dark;
  }
}

std::string RayShares::line(std::uint32_t rays) const {
  const auto percent = [](double share) { return format(100.0 * share) + " %"; };
  return "Each pixel is the mean of " + std::to_string(rays) + " rays; of those, " +
         percent(spilled) + " spill into the next lens, and " + percent(dark) +
         " show nothing (middle row)";
}

void RayShares::describe(std::uint32_t rays, Properties& out) const {
  out.emplace_back("lens.rays", static_cast<double>(rays));
  out.emplace_back("lens.spilled_rays", spilled);
  out.emplace_back("lens.dark_rays", dark);
}

std::vector<std::string> ThickLenticular::model_report() const {
  std::vector<std::string> out = Lenticular::model_report();
  out.push_back(m_shares.line(m_lens.rays()));
  return out;
}

Properties ThickLenticular::describe() const {
  Properties out = Lenticular::describe();
  m_shares.describe(m_lens.rays(), out);
  return out;
}

}  // namespace lentray::camera
