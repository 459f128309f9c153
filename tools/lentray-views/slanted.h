// What is in an integral image for slanted lenses: views, and what an eye sees through the sheet. Both
// have a pixel for each place of a regular grid, as wide as a lens along a row, that of the lens that
// is nearest to the place. For upright lenses these are the functions of strips.h.
// Errors: core::ImageError, worded for the user. Threads: any number.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tools/lentray-views/sheet.h"
#include "tools/lentray-views/strips.h"

namespace lentray::views {

core::StoredImage view_of(const core::StoredImage& integral, const Sheet& sheet, std::uint32_t view,
                          std::uint32_t count);
/// The eye of a slanted sheet is as high as the eye that the print is for.
core::StoredImage seen_by(const core::StoredImage& integral, const Sheet& sheet, const Eye& eye,
                          bool between);
/// What the lenses show to an eye, of a slanted sheet those of its middle row: 0 to 1 are places in the
/// lens's own cell from its left edge, other whole numbers are the cells beside it.
std::vector<double> cells_seen(const Sheet& sheet, const Eye& eye);
/// Lenses of so many pixels with that tangent, behind a picture of that size. Without the sheet's width
/// by its height pixels are square. Empty: the tangent is 0.
std::optional<camera::SlantedSheet> slanted_sheet(double pixels, double tangent,
                                                  std::uint32_t columns, std::uint32_t rows,
                                                  std::optional<double> aspect);
/// ", slanted by 9.462 degrees", or nothing.
std::string slant_text(const Sheet& sheet);
/// Throws of a slanted sheet: `what` its lenses do not have.
void refuse_slanted(const Sheet& sheet, const std::string& name, const std::string& what);

}  // namespace lentray::views
