#include "tools/lentray-diff/seen_sheet.h"

#include <cmath>
#include <numbers>
#include <optional>

#include "camera/slanted_sheet.h"
#include "core/base/formed.h"
#include "core/image/writer.h"
#include "tools/common/sheet_facts.h"

namespace lentray::diff {
namespace {

using core::formed;
using core::ImageError;
using core::StoredImage;
using tool::Facts;
using tool::number_of;

/// Columns where lens 0 begins in each row.
std::vector<double> slanted_origins(const StoredImage& image, const Facts& facts, double pixels,
                                    double degrees, const std::string& about) {
  camera::LensParameters lens;
  lens.pixels = pixels;
  lens.pitch = number_of(facts, "lens.pitch_mm");
  lens.slant = std::tan(degrees * std::numbers::pi / 180.0);
  const double height = number_of(facts, "lens.sheet_height_mm");
  if (!(lens.pitch > 0.0) || !(height > 0.0)) {
    throw ImageError(about + " has slanted lenses, and does not say their pitch and its height");
  }
  const camera::SlantedSheet sheet(lens, {image.width, image.height, height, 0.0, 0.0});
  std::vector<double> out(image.height);
  for (std::uint32_t row = 0; row < image.height; ++row) out[row] = sheet.shift(row + 0.5);
  return out;
}

void refuse_no_sheet(const StoredImage& image, const Facts& facts, bool is_told,
                     const std::string& name) {
  // What is taken out of a sheet has its lens data, and quilts have none.
  const bool has_data = facts.contains("lens.pixels") || facts.contains("quilt.columns");
  if (has_data && !tool::is_integral(facts)) {
    throw ImageError("'" + name + "' is no integral image: a view, a quilt or what an eye sees");
  }
  const std::string damage = is_told ? std::string() : tool::damage_of(image, facts, name);
  if (!damage.empty()) {
    throw ImageError(damage + " (or --lens-pixels N gives the pixels a lens that it has now)");
  }
}

/// Of the print, along its columns or its rows.
double dots_in(const Facts& facts, const char* name) {
  const double own = number_of(facts, name);
  return own > 0.0 ? own : number_of(facts, "lens.print_dpi");
}

/// "15 and 15.02 pixels a lens", where they differ by more than the digits that files have.
std::string unequal(double a, double b, const char* unit) {
  constexpr double kSame = 1e-6;
  if (std::abs(a - b) <= kSame * std::max(std::abs(a), std::abs(b))) return {};
  return formed("%.6g and %.6g %s", a, b, unit);
}

}  // namespace

SeenSheet seen_sheet_of(const StoredImage& image, const SeenArguments& arguments,
                        const std::string& name) {
  const std::string about = "'" + name + "'";
  const Facts facts = tool::facts_of(image);
  const camera::LensRequest& said = arguments.lens_words.lens;
  refuse_no_sheet(image, facts, said.pixels.has_value(), name);
  SeenSheet out;
  out.is_across = arguments.across || tool::lies_across(facts);
  out.lenses.pixels = said.pixels.value_or(number_of(facts, "lens.pixels"));
  out.eye.arc_minutes = arguments.arc_minutes;
  out.eye.distance = said.view_distance.value_or(number_of(facts, "lens.view_distance_mm"));
  out.eye.rows_an_inch = arguments.rows_an_inch().value_or(dots_in(facts, "lens.print_dpi_y"));
  out.columns_an_inch = said.print_dpi.value_or(dots_in(facts, "lens.print_dpi_x"));
  std::string missing;
  const auto need = [&](double value, const char* option) {
    if (!(value > 0.0)) missing += (missing.empty() ? "" : ", ") + std::string(option);
  };
  need(out.lenses.pixels, "--lens-pixels N");
  need(out.eye.rows_an_inch, "--dpi D");
  need(out.eye.distance, "--view-distance MM");
  if (!missing.empty()) {
    const bool is_far = missing.starts_with("--view") && facts.contains("lens.view_distance_mm");
    throw ImageError(
        about +
        (is_far ? " is for an infinite distance: give " : " does not say all of its sheet: give ") +
        missing);
  }
  out.slant = number_of(facts, "lens.slant_deg");
  if (out.slant != 0.0) {
    out.lenses.origins = slanted_origins(image, facts, out.lenses.pixels, out.slant, about);
  }
  return out;
}

std::string other_sheet(const SeenSheet& a, const SeenSheet& b) {
  if (a.is_across != b.is_across) return "lenses that lie across and lenses that stand upright";
  for (const std::string& why :
       {unequal(a.lenses.pixels, b.lenses.pixels, "pixels a lens"),
        unequal(a.slant, b.slant, "degrees of slant"),
        unequal(a.eye.rows_an_inch, b.eye.rows_an_inch, "rows an inch"),
        unequal(a.eye.distance, b.eye.distance, "mm of viewing distance")}) {
    if (!why.empty()) return why;
  }
  return {};
}

}  // namespace lentray::diff
