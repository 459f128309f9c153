#include "tools/lentray-print/lens_data.h"

#include <cmath>

#include "camera/text.h"
#include "tools/common/sheet_facts.h"
#include "tools/lentray-print/page.h"
#include "tools/lentray-print/page_error.h"

namespace lentray::print {

using camera::format;

namespace {

constexpr double kSame = 1e-6;  ///< relative

std::optional<std::string> field_of(const core::StoredImage& image, const std::string& name) {
  const tool::Facts facts = tool::facts_of(image);
  const auto found = facts.find("lens." + name);
  return found == facts.end() ? std::nullopt : std::optional(found->second);
}

std::optional<double> positive(double value) {
  return value > 0.0 ? std::optional(value) : std::nullopt;
}
std::optional<double> positive_field(const core::StoredImage& image, const std::string& name) {
  return positive(tool::number_of(tool::facts_of(image), "lens." + name));
}

std::optional<double> resolution(const core::StoredImage& image, const char* name) {
  const auto unit = image.attributes.find("ResolutionUnit");
  const bool is_cm = unit != image.attributes.end() && unit->second == "cm";
  return positive(tool::number_of(image.attributes, name) * (is_cm ? 2.54 : 1.0));
}

bool differs(double a, double b) { return std::fabs(a - b) > kSame * std::fabs(b); }

void check_same(const std::string& name, const char* option, const std::optional<double>& given,
                const std::optional<double>& told, const std::string& what) {
  if (!given || !told || !differs(*given, *told)) return;
  throw PageError("'" + name + "' says " + format(*told) + " " + what + ", which " + option + " " +
                  format(*given) + " contradicts; a picture for another print is rendered anew");
}

std::optional<LensOfPicture> lens_of(const core::StoredImage& image) {
  const auto pitch = positive_field(image, "pitch_mm"),
             f = positive_field(image, "focal_length_mm");
  const auto ior = positive_field(image, "ior");
  if (!pitch || !f || !ior) return std::nullopt;
  LensOfPicture lens{*pitch, *f, *ior};
  lens.view_distance = positive_field(image, "view_distance_mm").value_or(0.0);
  lens.model = field_of(image, "model").value_or("pinhole");
  lens.has_scenes_eye = field_of(image, "scene_distance").has_value();
  return lens;
}

void check_range(const LensData& data, const std::string& name) {
  const auto is_beyond = [](double value, double least, double most) {
    return !(value >= least && value <= most);
  };
  if (is_beyond(data.pixels, 1.0, 1e5)) {
    throw PageError("'" + name + "': " + format(data.pixels) +
                    " pixels a lens; 1 to 100000 are possible");
  }
  if (is_beyond(data.dpi_x, 1.0, 1e5) || is_beyond(data.dpi_y, 1.0, 1e5)) {
    throw PageError("'" + name + "': a resolution of " + format(data.dpi_x) + " x " +
                    format(data.dpi_y) + " dpi; 1 to 100000 are possible");
  }
}

}  // namespace

double LensData::print_pitch() const { return pixels * kInch / dpi_x; }
double LensData::print_lpi() const { return dpi_x / pixels; }

double slant_in(const core::StoredImage& image) {
  return tool::number_of(tool::facts_of(image), "lens.slant_deg");
}

LensData lens_data_of(const core::StoredImage& image, const GivenLensData& given,
                      const std::string& name) {
  if (field_of(image, "view")) {
    throw PageError("'" + name + "' is a single view; an integral image is needed");
  }
  if (const double slant = slant_in(image); slant != 0.0) {
    throw PageError("'" + name + "' is for lenses slanted by " + format(slant) +
                    " degrees; pages are for upright ones: print the picture itself at its "
                    "resolution, without scaling");
  }
  LensData data;
  const std::optional<double> told_pixels = positive_field(image, "pixels");
  std::optional<double> told_x = positive_field(image, "print_dpi_x");
  std::optional<double> told_y = positive_field(image, "print_dpi_y");
  check_same(name, "--pixels", given.pixels, told_pixels, "pixels a lens");
  check_same(name, "--dpi", given.dpi_x, told_x, "pixels an inch");
  check_same(name, "--dpi-y", given.dpi_y, told_y, "pixels an inch from top to bottom");
  // Other programs change a file's resolution without asking: what the user says counts more.
  const std::optional<double> dpi_x = told_x        ? told_x
                                      : given.dpi_x ? given.dpi_x
                                                    : resolution(image, "XResolution");
  if (!dpi_x) {
    throw PageError("'" + name + "' does not say at what resolution it is printed; give --dpi D");
  }
  data.dpi_x = *dpi_x;
  data.dpi_y = told_y        ? *told_y
               : given.dpi_y ? *given.dpi_y
               : given.dpi_x ? *given.dpi_x
                             : resolution(image, "YResolution").value_or(data.dpi_x);
  std::optional<double> pixels = told_pixels ? told_pixels : given.pixels;
  data.lens = lens_of(image);
  if (given.lens_pitch && data.lens && differs(*given.lens_pitch, data.lens->pitch)) {
    throw PageError("'" + name + "' was rendered for lenses of " + format(data.lens->pitch) +
                    " mm, not of " + format(*given.lens_pitch) +
                    " mm; --pitch fits it to a measured pitch");
  }
  if (!pixels && given.lens_pitch) pixels = *given.lens_pitch * data.dpi_x / kInch;
  if (!pixels) {
    throw PageError(
        "'" + name +
        "' has no lens data of lentray; give --pixels N, the pixels a lens, or --lpi L");
  }
  data.pixels = *pixels;
  check_range(data, name);
  if (const std::string damage = tool::damage_of(image, tool::facts_of(image), name);
      !damage.empty()) {
    throw PageError(damage);
  }
  return data;
}

}  // namespace lentray::print
