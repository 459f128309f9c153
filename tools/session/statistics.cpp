#include "tools/session/statistics.h"

#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string_view>
#include <variant>

namespace lentray::tool {
namespace {

shadow::LensReport lens_report(const camera::Lenticular& sheet) {
  shadow::LensReport out;
  out.parameters = sheet.sheet().lens();
  out.lenses = sheet.sheet().lenses();
  out.views = sheet.sheet().views();
  out.lens_front = sheet.placement().front;
  out.scene_units_per_mm = sheet.scale();
  out.sheet_width = sheet.sheet().sheet_width();
  out.sheet_height = sheet.placement().height / sheet.scale();
  return out;
}

/// Of the space in which colours are computed: a power, "sRGB", or null where they go to the file
/// as they are.
nlohmann::json working_gamma(const core::SceneSettings& settings) {
  if (settings.assumed_gamma > 0.0) return settings.assumed_gamma;
  return settings.assumed_gamma_set ? nlohmann::json("sRGB") : nlohmann::json();
}

/// The camera's properties below "lens"; vectors as arrays.
nlohmann::json lens_json(const camera::Camera& camera) {
  nlohmann::json out = nlohmann::json::object();
  constexpr std::string_view kPrefix = "lens.";
  for (const camera::Property& property : camera.describe()) {
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

nlohmann::json statistics(shadow::RunReport report, const CameraSetup& camera,
                          const core::SceneSettings& settings) {
  if (camera.sheet) report.lens = lens_report(*camera.sheet);
  nlohmann::json out = shadow::to_json(report);
  out["image"]["working_gamma"] = working_gamma(settings);
  if (camera.sheet) out["lens"].update(lens_json(camera.camera()));
  return out;
}

}  // namespace lentray::tool
