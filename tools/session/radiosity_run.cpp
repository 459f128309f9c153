#include "tools/session/radiosity_run.h"

#include <cstdint>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/irradiance/irradiance_cache.h"
#include "core/scene/scene.h"
#include "tools/session/camera_setup.h"

namespace lentray::tool {
namespace {

/// Of pictures with more pixels, and of lens sheets, not each is looked at before the picture.
constexpr double kMostPixels = 1e6;

core::RadiosityPassSetup pass_setup(const core::Scene& scene, const camera::Camera& camera,
                                    bool is_sheet, const core::Vec3& eye,
                                    const core::ShadowTesterFactory& shadows) {
  const bool is_large = static_cast<double>(camera.width()) * camera.height() > kMostPixels;
  return {.scene = scene,
          .camera = camera,
          .width = camera.width(),
          .height = camera.height(),
          .eye = eye,
          .sees_every_pixel = !is_sheet && !is_large,
          .shadows = shadows};
}

}  // namespace

core::Vec3 radiosity_eye(const parser::CameraRequest& request) {
  const camera::Projection& p = request.projection;
  if (request.kind != "lenticular") return p.location;
  return p.location - core::normalized(p.direction) * core::length(p.right);
}

RadiosityRun::RadiosityRun(const core::Scene& scene, const CameraSetup& setup,
                           const core::Vec3& eye, const core::ShadowTesterFactory& shadows,
                           core::Illumination& light)
    : m_scene(scene), m_light(light), m_sheet(setup.sheet),
      m_pass(
          pass_setup(scene, m_sheet ? *m_sheet : setup.camera(), m_sheet != nullptr, eye, shadows),
          light) {}

std::string RadiosityRun::warning() const {
  if (!m_light.irradiance || !m_light.irradiance->is_dark()) return {};
  const bool by_version = m_scene.settings().language_version >= 370;
  return std::string("radiosity: no light reaches any surface") +
         (by_version ? "; from #version 3.7 on `ambient` is none where there is radiosity, "
                       "`emission` is"
                     : "");
}

std::string RadiosityRun::text() const {
  constexpr int kColumn = 10;
  const core::RadiosityReport& report = m_pass.report();
  std::ostringstream out;
  out << "Samples of radiosity\n  level" << std::setw(kColumn) << "places";
  for (std::size_t depth = 0; depth < report.levels.front().depths.size(); ++depth) {
    out << std::setw(kColumn) << "depth " + std::to_string(depth);
  }
  out << '\n';
  for (std::size_t i = 0; i < report.levels.size(); ++i) {
    const core::RadiosityReport::Level& level = report.levels[i];
    const bool is_pixels = report.sees_pixels && i + 1 == report.levels.size();
    out << std::setw(7) << (is_pixels ? "pixels" : std::to_string(i + 1)) << std::setw(kColumn)
        << level.places;
    for (const core::GatherCounts& depth : level.depths) out << std::setw(kColumn) << depth.gathers;
    out << '\n';
  }
  return out.str();
}

nlohmann::json RadiosityRun::json() const {
  nlohmann::json levels = nlohmann::json::array();
  for (const core::RadiosityReport::Level& level : m_pass.report().levels) {
    nlohmann::json depths = nlohmann::json::array();
    for (const core::GatherCounts& depth : level.depths) {
      depths.push_back({{"queries", depth.queries},
                        {"samples", depth.gathers},
                        {"rays", depth.rays},
                        {"not_kept", depth.not_kept}});
    }
    levels.push_back({{"places", level.places}, {"depths", depths}});
  }
  return {{"levels", levels}, {"sees_every_pixel", m_pass.report().sees_pixels}};
}

}  // namespace lentray::tool
