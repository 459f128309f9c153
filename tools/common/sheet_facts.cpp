#include "tools/common/sheet_facts.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <string_view>

namespace lentray::tool {
namespace {

constexpr std::string_view kPrefix = "lentray:";
constexpr double kMmAnInch = 25.4;

/// What it was rendered with; 0: unknown.
double rows_told(const Facts& facts) {
  return std::round(number_of(facts, "lens.print_height_mm") *
                    number_of(facts, "lens.print_dpi_y") / kMmAnInch);
}

std::string whole_text(double value) { return std::to_string(std::llround(value)); }

}  // namespace

Facts facts_of(const core::StoredImage& image) {
  Facts out;
  for (const auto& [name, value] : image.attributes) {
    if (name.starts_with(kPrefix)) out[name.substr(kPrefix.size())] = value;
  }
  const auto description = image.attributes.find("ImageDescription");
  if (description == image.attributes.end()) return out;
  std::istringstream lines(description->second);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t equals = line.find('=');
    if (!line.starts_with(kPrefix) || equals == std::string::npos) continue;
    out[line.substr(kPrefix.size(), equals - kPrefix.size())] = line.substr(equals + 1);
  }
  return out;
}

double number_of(const Facts& facts, const std::string& name) {
  const auto found = facts.find(name);
  if (found == facts.end()) return 0.0;
  const double value = std::strtod(found->second.c_str(), nullptr);
  return std::isfinite(value) ? value : 0.0;
}

bool is_integral(const Facts& facts) {
  constexpr const char* kTakenOut[] = {"lens.view", "lens.lens", "quilt.columns",
                                       "eye.angle_degrees", "stereo"};
  return facts.contains("lens.pixels") &&
         std::ranges::none_of(kTakenOut, [&](const char* key) { return facts.contains(key); });
}

bool lies_across(const Facts& facts) {
  const auto said = facts.find("lens.lenses_lie");
  return said != facts.end() && said->second == "across";
}

std::string damage_of(const core::StoredImage& image, const Facts& facts, const std::string& name) {
  const double width =
      std::round(number_of(facts, "lens.lenses") * number_of(facts, "lens.pixels"));
  const bool is_slanted = number_of(facts, "lens.slant_deg") != 0.0;
  const double height = is_slanted ? rows_told(facts) : 0.0;
  const bool is_wide = width <= 0.0 || width == image.width;
  if (is_wide && (height <= 0.0 || height == image.height)) return {};
  const std::string then =
      is_wide ? whole_text(height) + " pixels high" : whole_text(width) + " pixels wide";
  return "'" + name + "' was rendered " + then + " and has " +
         std::to_string(is_wide ? image.height : image.width) +
         " now: resizing and cropping destroy the strips behind the lenses; render it anew";
}

std::string height_change_of(const core::StoredImage& image, const Facts& facts,
                             const std::string& name) {
  const double height = rows_told(facts);
  if (height <= 0.0 || height == image.height) return {};
  return "'" + name + "' was rendered " + whole_text(height) + " pixels high and has " +
         std::to_string(image.height) + " now: the height and shape it gives are those of before";
}

}  // namespace lentray::tool
