#include "tools/lentray-diff/sheet.h"

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

#include "core/numeric/lens_columns.h"
#include "tools/common/json_fields.h"

namespace lentray::diff {

using core::Vec3;
using nlohmann::json;

bool Sheet::is_finite() const { return std::isfinite(view_distance); }
bool Sheet::has_views() const { return pixels == std::floor(pixels); }
std::uint32_t Sheet::views() const { return has_views() ? static_cast<std::uint32_t>(pixels) : 0; }

double Sheet::print_pitch() const {
  return is_finite() ? pitch * (1.0 + focal_length / (ior * view_distance)) : pitch;
}

std::uint32_t Sheet::lens_of(std::uint32_t column) const {
  return static_cast<std::uint32_t>(core::LensColumns{pixels}.lens_of(column));
}

double Sheet::cell_offset(std::uint32_t view) const {
  return ((view + 0.5) / pixels - 0.5) * print_pitch() * depth_factor;
}

std::optional<double> Sheet::slope(std::uint32_t column, const PixelOffset& place) const {
  const std::uint32_t lens = lens_of(column);
  const double x = axis(lens + place.across);
  const double held = scene_distance ? 1.0 : depth_factor;
  const double cell = ((column + 0.5 + place.turn) / pixels - (lens + 0.5)) * print_pitch() * held;
  const double along = is_finite() ? x * focal_length / (ior * view_distance) : 0.0;
  const double offset = cell + along + print_shift();
  double light = ior * offset / focal_length;
  if (!paraxial) {
    const double sine = ior * std::sin(std::atan(offset / focal_length));
    if (std::abs(sine) >= 1.0) return std::nullopt;
    light = std::tan(std::asin(sine));
  }
  if (!scene_distance) return light;
  return depth_factor * (light - x / view_distance) + x * scale() / *scene_distance + eye_slope_x;
}

double Sheet::print_shift() const {
  if (scene_distance) return 0.0;  // the viewer is before the middle
  if (is_finite() || paraxial) return eye_slope_x * focal_length / ior;
  return focal_length * std::tan(std::asin(std::sin(std::atan(eye_slope_x)) / ior));
}

std::uint32_t Sheet::view_width(std::uint32_t view) const {
  return view < columns ? (columns - 1 - view) / views() + 1 : 0;
}

Sheet Sheet::finer(int parts) const {
  Sheet out = *this;
  out.pixels = pixels * parts;
  out.columns = columns * static_cast<std::uint32_t>(parts);
  return out;
}

namespace {

const json& member(const json& lens, const char* key) {
  const auto found = lens.find(key);
  if (found == lens.end()) {
    throw std::runtime_error(std::string("lentray's statistics have no \"lens.") + key + "\"");
  }
  return *found;
}

double number(const json& lens, const char* key) {
  const json& value = member(lens, key);
  if (!value.is_number()) {
    throw std::runtime_error(std::string("\"lens.") + key + "\" is no number");
  }
  return value.get<double>();
}

Vec3 vector(const json& lens, const char* key) {
  const json& v = member(lens, key);
  if (!v.is_array() || v.size() != 3) {
    throw std::runtime_error(std::string("\"lens.") + key + "\" is no vector");
  }
  return {v[0].get<double>(), v[1].get<double>(), v[2].get<double>()};
}

/// Of an eye: null and 0 stand for infinity.
double distance(const json& lens, const char* key) {
  const json& value = member(lens, key);
  const double v = value.is_null() ? 0.0 : number(lens, key);
  return v > 0.0 ? v : std::numeric_limits<double>::infinity();
}

}  // namespace

std::optional<Sheet> sheet_of(const json& statistics) {
  if (!statistics.contains("lens")) return std::nullopt;
  const json& lens = statistics["lens"];
  const json& image = statistics.at("image");
  Sheet s;
  s.centre = vector(lens, "centre");
  s.right = vector(lens, "right");
  s.up = vector(lens, "up");
  s.width = length(s.right);
  s.height = length(s.up);
  s.right = normalized(s.right);
  s.up = normalized(s.up);
  s.direction = normalized(vector(lens, "direction"));
  s.pitch = number(lens, "pitch_mm");
  s.focal_length = number(lens, "focal_length_mm");
  s.ior = number(lens, "ior");
  s.pixels = number(lens, "pixels");
  s.view_distance = distance(lens, "view_distance_mm");
  if (lens.contains("depth_factor")) s.depth_factor = number(lens, "depth_factor");
  s.front = number(lens, lens.contains("front") ? "front" : "lens_front");
  if (const auto slant = lens.find("slant_deg"); slant != lens.end() && *slant != 0.0) {
    throw std::runtime_error("there is no reference for slanted lenses (Lens_Slant)");
  }
  const auto model = member(lens, "model").get<std::string>();
  if (model != "paraxial" && model != "pinhole") {
    throw std::runtime_error("there is no reference for the lens model " + model +
                             ": there are ones for paraxial and pinhole");
  }
  s.paraxial = model == "paraxial";
  if (lens.contains("scene_distance")) s.scene_distance = distance(lens, "scene_distance");
  const char* const eye = s.scene_distance ? "scene_eye_slope" : "eye_slope";
  if (const auto slope = lens.find(eye); slope != lens.end()) {
    s.eye_slope_x = slope->at(0).get<double>();
    s.eye_slope_y = slope->at(1).get<double>();
  }
  // A view alone is as wide as it has lenses; the sheet is still the whole one.
  s.columns = lens.contains("view")
                  ? static_cast<std::uint32_t>(std::lround(number(lens, "lenses") * s.pixels))
                  : tool::whole_of<std::uint32_t>(image.at("width"));
  // Pictures of views are upright, also where the sheet is on its side.
  s.turned_views = lens.contains("view") && lens.value("lenses_lie", "") == "across";
  s.rows = tool::whole_of<std::uint32_t>(image.at(s.turned_views ? "width" : "height"));
  if (std::abs(dot(s.right, s.direction)) > 1e-9 || std::abs(dot(s.up, s.direction)) > 1e-9) {
    throw std::runtime_error("\"lens.direction\" is not perpendicular to the sheet");
  }
  return s;
}

}  // namespace lentray::diff
