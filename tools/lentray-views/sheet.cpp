#include "tools/lentray-views/sheet.h"

#include <cmath>
#include <cstdlib>
#include <numbers>

#include "camera/text.h"
#include "core/image/writer.h"

namespace lentray::views {
namespace {

using camera::LensModel;
using camera::LensParameters;
using core::ImageError;

/// Takes the user's word, or else the file's; false: nobody says it.
bool take(const std::optional<double>& said, const Facts& facts, const char* name,
          const std::string& about, double& value) {
  if (said) {
    value = *said;
    return true;
  }
  if (!facts.contains(name)) return false;
  value = number_in(facts, name, about);
  return true;
}

std::optional<LensModel> model_in(const Facts& facts) {
  const auto found = facts.find("lens.model");
  return found == facts.end() ? std::nullopt : camera::model_named(found->second);
}

/// Horizontal slope of the line from the eye to the sheet's middle: the first of three numbers.
double eye_slope_in(const Facts& facts) { return tool::number_of(facts, "lens.eye_slope"); }

/// The second of the three.
double eye_slope_up_in(const Facts& facts) {
  const auto found = facts.find("lens.eye_slope");
  const std::size_t comma = found == facts.end() ? std::string::npos : found->second.find(',');
  return comma == std::string::npos ? 0.0 : std::strtod(found->second.c_str() + comma + 1, nullptr);
}

double aspect_in(const core::StoredImage& image, const Facts& facts, const std::string& about) {
  const double width = number_in(facts, "lens.sheet_width_mm", about),
               height = number_in(facts, "lens.sheet_height_mm", about);
  if (width > 0.0 && height > 0.0) return width / height;
  const double x = tool::number_of(image.attributes, "XResolution"),
               y = tool::number_of(image.attributes, "YResolution");
  return x > 0.0 && y > 0.0 ? image.width / x / (image.height / y) : 0.0;
}

void refuse_other_pictures(const Facts& facts, const std::string& about) {
  if (facts.contains("quilt.columns")) {
    throw ImageError(about + " is a quilt, and no integral image");
  }
  const auto view = facts.find("lens.view");
  if (view != facts.end()) {
    throw ImageError(about + " is view " + view->second + " of a sheet, and no integral image");
  }
}

/// Whoever gives the pixels a lens knows what became of the picture.
void refuse_damaged(const core::StoredImage& image, const Facts& facts, const SheetOptions& options,
                    const std::string& name) {
  if (options.pixels) return;
  const std::string damage = tool::damage_of(image, facts, name);
  if (!damage.empty()) {
    throw ImageError(damage + " (or --lens-pixels N gives the pixels a lens that it has now)");
  }
}

}  // namespace

std::optional<double> said_aspect(const SheetOptions& options) {
  if (!options.aspect || !options.across) return options.aspect;
  return 1.0 / *options.aspect;
}

std::optional<camera::SlantedSheet> slanted_sheet(const LensParameters& lens, std::uint32_t columns,
                                                  std::uint32_t rows, double aspect,
                                                  double eye_slope_x, double eye_slope_y) {
  if (lens.slant == 0.0) return std::nullopt;
  // Of a sheet of unknown height, pixels are square.
  const double width = camera::LensSheet(lens, columns).sheet_width();
  const double height = aspect > 0.0 ? width / aspect : width * rows / columns;
  return camera::SlantedSheet(lens, {columns, rows, height, eye_slope_x, eye_slope_y});
}

Sheet sheet_of(const core::StoredImage& image, const SheetOptions& options,
               const std::string& name) {
  const std::string about = "'" + name + "'";
  const Facts facts = facts_of(image);
  refuse_other_pictures(facts, about);
  refuse_damaged(image, facts, options, name);
  LensParameters lens;
  std::string missing;
  const auto need = [&](bool known, const char* option) {
    if (!known) missing += (missing.empty() ? "" : ", ") + std::string(option);
  };
  if (!take(options.pixels, facts, "lens.pixels", about, lens.pixels)) {
    throw ImageError(about + " does not say how many pixels a lens has: --lens-pixels N says it");
  }
  need(take(options.pitch, facts, "lens.pitch_mm", about, lens.pitch), "--lens-pitch");
  need(take(options.focal_length, facts, "lens.focal_length_mm", about, lens.focal_length),
       "--lens-focal-length");
  need(take(options.ior, facts, "lens.ior", about, lens.ior), "--lens-ior");
  double distance = 0.0;
  need(take(options.view_distance, facts, "lens.view_distance_mm", about, distance),
       "--view-distance");
  if (distance > 0.0) lens.view_distance = distance;
  double degrees = 0.0;
  if (options.slant) {
    lens.slant = *options.slant;
  } else if (take({}, facts, "lens.slant_deg", about, degrees)) {
    lens.slant = std::tan(degrees * std::numbers::pi / 180.0);
  }
  const auto model = options.model ? options.model : model_in(facts);
  // As lentray itself chooses.
  lens.model = model.value_or(lens.is_finite() ? LensModel::kParaxial : LensModel::kPinhole);
  if (const std::string why = camera::complaint(lens); !why.empty()) {
    throw ImageError(about + ": " + why);
  }
  if (lens.pixels > image.width) {
    throw ImageError(about + " is " + std::to_string(image.width) +
                     " pixels wide, which is less than a lens of " + camera::format(lens.pixels));
  }
  Sheet out{camera::LensSheet(lens, image.width, eye_slope_in(facts)), missing,
            said_aspect(options).value_or(aspect_in(image, facts, about))};
  out.slanted = slanted_sheet(lens, image.width, image.height, out.aspect, eye_slope_in(facts),
                              eye_slope_up_in(facts));
  return out;
}

void need_optics(const Sheet& sheet, const std::string& name) {
  if (sheet.missing.empty()) return;
  throw ImageError("'" + name + "' does not say all of its lenses: give " + sheet.missing);
}

double need_aspect(const Sheet& sheet, const std::string& name) {
  if (sheet.aspect > 0.0) return sheet.aspect;
  throw ImageError("'" + name +
                   "' does not say how large its sheet is: give --aspect, its width by its height");
}

}  // namespace lentray::views
