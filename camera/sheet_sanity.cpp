#include "camera/sheet_sanity.h"

#include <cmath>
#include <tuple>

#include "camera/text.h"

namespace lentray::camera {
namespace {

constexpr double kWidestLens = 5.0, kLargestSheet = 2000.0;  // mm
constexpr double kFewestLenses = 10.0, kFewestPixels = 6.0;

/// Three digits, so rounded that the condition holds.
std::string at_least(double value) {
  const double step = std::pow(10.0, std::floor(std::log10(value)) - 2.0);
  return format(std::ceil(value / step - 1e-9) * step);
}
std::string at_most(double value) {
  const double step = std::pow(10.0, std::floor(std::log10(value)) - 2.0);
  return format(std::floor(value / step + 1e-9) * step);
}

}  // namespace

std::string resolution_for(const LensParameters& lens, double pixels) {
  const double times = pixels / lens.pixels;
  return "at least " + at_least(lens.print_dpi() * times) + " dpi, or at most " +
         at_most(lens.lenses_per_inch() / times) + " lpi";
}

std::vector<std::string> sheet_sanity(const LensParameters& lens, const LensRequest& asked,
                                      double width, double height) {
  std::vector<std::string> lines;
  if (!asked.has_print_data()) return lines;
  if (lens.pitch > kWidestLens) {
    lines.push_back("the lenses are " + brief(lens.pitch) +
                    " mm wide, wider than sheets are made: Lens_LPI is lenses an inch, Lens_Pitch "
                    "the width of one in mm");
  }
  for (const auto& [size, name, along] :
       {std::tuple{width, "Sheet_Width", "wide"}, std::tuple{height, "Sheet_Height", "high"}}) {
    if (size <= kLargestSheet) continue;
    lines.push_back("the sheet is " + brief(size / 1000.0) + " m " + along +
                    ": if it is not, say " + name + " with its unit, such as " +
                    brief(size / 10.0) + "mm");
  }
  const double lenses = width * lens.slant_cosine() / lens.pitch;
  if (lenses < kFewestLenses) {
    lines.push_back("the sheet has " + brief(lenses) + " lenses: a Sheet_Width of " +
                    at_least(kFewestLenses * lens.pitch / lens.slant_cosine()) + " mm, or " +
                    at_least(lens.lenses_per_inch() * kFewestLenses / lenses) +
                    " lpi, is the least that shows a picture");
  }
  if (lens.pixels < kFewestPixels) {
    lines.push_back("a lens has " + brief(lens.pixels) + " pixels, which is as many views: " +
                    resolution_for(lens, kFewestPixels) + " give it six");
  }
  return lines;
}

}  // namespace lentray::camera
