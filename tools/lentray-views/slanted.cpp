#include "tools/lentray-views/slanted.h"

#include <cmath>
#include <numbers>

#include "camera/lenticular.h"
#include "camera/text.h"
#include "core/image/writer.h"

namespace lentray::views {
namespace {

using camera::SlantedSheet;
using core::StoredImage;

StoredImage slanted_view(const StoredImage& integral, const SlantedSheet& sheet,
                         std::uint32_t width, std::uint32_t view, std::uint32_t count) {
  if (view >= count) refuse_view(view, count);
  return seen_at(integral, width, false, [&](std::uint32_t i, std::uint32_t row) {
    return static_cast<double>(sheet.view_column(view, count, i, static_cast<std::int32_t>(row)));
  });
}

struct SeenPlace {
  double lens = 0.0;         ///< that is nearest to a place of a row
  double cell_offset = 0.0;  ///< of the print that it shows, mm across it
};
SeenPlace seen_place(const SlantedSheet& sheet, const Eye& eye, std::uint32_t place,
                     std::uint32_t row) {
  const double middle = row + 0.5;
  const auto lens = static_cast<double>(sheet.nearest_lens(place, static_cast<std::int32_t>(row)));
  const double axis = sheet.axis_of(lens);
  const double x = sheet.x_of(axis, sheet.row_height(middle));
  const double slope = (eye.distance > 0.0 ? x / eye.distance : 0.0) -
                       std::tan(eye.angle * std::numbers::pi / 180.0);
  const double offset = sheet.offset_seen(slope, sheet.rise(middle));
  return {lens, offset - sheet.offset_of_cell(axis)};
}

/// The place in the print that an eye sees at a place of a row, in pixels, 0 at the middle of the first.
double seen_column(const SlantedSheet& sheet, const Eye& eye, std::uint32_t place,
                   std::uint32_t row) {
  const SeenPlace seen = seen_place(sheet, eye, place, row);
  return sheet.column_at(seen.cell_offset, seen.lens, row + 0.5) - 0.5;
}

}  // namespace

StoredImage view_of(const StoredImage& integral, const Sheet& sheet, std::uint32_t view,
                    std::uint32_t count) {
  if (!sheet.slanted) return view_of(integral, sheet.lenses, view, count);
  const std::uint32_t width = camera::view_width(sheet.lenses, 0, count);
  return slanted_view(integral, *sheet.slanted, width, view, count);
}

StoredImage seen_by(const StoredImage& integral, const Sheet& sheet, const Eye& eye, bool between) {
  if (!sheet.slanted) return seen_by(integral, sheet.lenses, eye, between);
  const std::uint32_t width = camera::view_width(sheet.lenses, 0, 1);
  return seen_at(integral, width, between, [&](std::uint32_t i, std::uint32_t row) {
    return seen_column(*sheet.slanted, eye, i, row);
  });
}

std::vector<double> cells_seen(const Sheet& sheet, const Eye& eye) {
  std::vector<double> out;
  if (sheet.slanted) {
    const std::uint32_t row = sheet.slanted->print().height / 2;
    for (std::uint32_t i = 0; i < camera::view_width(sheet.lenses, 0, 1); ++i) {
      const SeenPlace seen = seen_place(*sheet.slanted, eye, i, row);
      out.push_back(seen.cell_offset / sheet.lenses.lens().print_pitch() + 0.5);
    }
    return out;
  }
  for (const double place : places_seen(sheet.lenses, eye)) {
    const auto lens = static_cast<double>(out.size());
    out.push_back((place + 0.5) / sheet.lenses.lens().pixels - lens);
  }
  return out;
}

std::optional<SlantedSheet> slanted_sheet(double pixels, double tangent, std::uint32_t columns,
                                          std::uint32_t rows, std::optional<double> aspect) {
  camera::LensParameters lens;
  lens.pixels = pixels;
  lens.slant = tangent;
  return slanted_sheet(lens, columns, rows, aspect.value_or(0.0));
}

std::string slant_text(const Sheet& sheet) {
  if (!sheet.slanted) return {};
  return ", slanted by " + camera::brief(camera::slant_degrees(sheet.lenses.lens())) + " degrees";
}

void refuse_slanted(const Sheet& sheet, const std::string& name, const std::string& what) {
  if (!sheet.slanted) return;
  throw core::ImageError("'" + name + "' is for lenses slanted by " +
                         camera::brief(camera::slant_degrees(sheet.lenses.lens())) +
                         " degrees: " + what);
}

}  // namespace lentray::views
