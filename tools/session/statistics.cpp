#include "tools/session/statistics.h"

#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string_view>
#include <variant>

namespace lentray::tool {
namespace {

/// What every camera of a sheet has, views and quilts too; lengths in mm.
nlohmann::json lens_statistics(const camera::Lenticular& sheet) {
  const camera::LensParameters& p = sheet.sheet().lens();
  nlohmann::json out{{"pitch_mm", p.pitch},
                     {"focal_length_mm", p.focal_length},
                     {"ior", p.ior},
                     {"pixels", p.pixels},
                     {"model", camera::name_of(p.model)},
                     {"print_pitch_mm", p.print_pitch()},
                     {"pixel_size_mm", p.pixel_size()},
                     {"print_dpi", p.print_dpi()},
                     {"lenses_per_inch", p.lenses_per_inch()},
                     {"lenses", sheet.sheet().lenses()},
                     {"views", sheet.sheet().views()},
                     {"lens_front", sheet.placement().front},
                     {"scene_units_per_mm", sheet.scale()},
                     {"sheet_width_mm", sheet.sheet().sheet_width()},
                     {"sheet_height_mm", sheet.placement().height / sheet.scale()}};
  // JSON has no infinity: null is the paper's camera.
  out["view_distance_mm"] = p.is_finite() ? nlohmann::json(p.view_distance) : nlohmann::json();
  return out;
}

/// Of the space in which colours are computed: a power, "sRGB", or null where they go to the file
/// as they are.
nlohmann::json working_gamma(const core::SceneSettings& settings) {
  if (settings.assumed_gamma > 0.0) return settings.assumed_gamma;
  return settings.assumed_gamma_set ? nlohmann::json("sRGB") : nlohmann::json();
}

/// The camera's properties below "lens"; vectors as arrays.
nlohmann::json lens_json(const CameraSetup& setup) {
  nlohmann::json out = nlohmann::json::object();
  constexpr std::string_view kPrefix = "lens.";
  for (const camera::Property& property : properties_of(setup)) {
    if (property.first.rfind(kPrefix, 0) != 0) continue;
    nlohmann::json& value = out[property.first.substr(kPrefix.size())];
    if (const auto* text = std::get_if<std::string>(&property.second)) {
      value = *text;
    } else if (const auto* v = std::get_if<core::Vec3>(&property.second)) {
      value = {v->x, v->y, v->z};
    } else {
      const double number = std::get<double>(property.second);
      constexpr double kExact = 9007199254740992.0;  // 2^53
      if (number == std::floor(number) && std::fabs(number) < kExact) {
        value = static_cast<std::int64_t>(number);
      } else {
        value = number;
      }
    }
  }
  return out;
}

}  // namespace

nlohmann::json statistics(const shadow::RunReport& report, const CameraSetup& camera,
                          const core::SceneSettings& settings) {
  nlohmann::json out = shadow::to_json(report);
  out["image"]["working_gamma"] = working_gamma(settings);
  if (!camera.sheet) return out;
  out["lens"] = lens_statistics(*camera.sheet);
  out["lens"].update(lens_json(camera));
  return out;
}

}  // namespace lentray::tool
