#include "tools/session/radiosity_run.h"

#include <cstdint>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <sstream>
#include <utility>

#include "core/irradiance/irradiance_cache.h"
#include "core/scene/scene.h"
#include "tools/session/radiosity_lattice.h"

namespace lentray::tool {
namespace {

core::RadiosityPassSetup pass_setup(const core::Scene& scene, const RadiosityLattice& lattice,
                                    const core::Vec3& eye, const core::ShadowTesterFactory& shadows,
                                    std::uint64_t most_samples) {
  return {.scene = scene,
          .camera = lattice.camera,
          .width = lattice.camera.width(),
          .height = lattice.camera.height(),
          .eye = eye,
          .sees_every_pixel = lattice.sees_every_pixel,
          .most_samples = most_samples,
          .shadows = shadows};
}

}  // namespace

RadiosityRun::RadiosityRun(const core::Scene& scene, const CameraSetup& setup,
                           const core::Vec3& eye, const core::ShadowTesterFactory& shadows,
                           core::Illumination& light, std::uint64_t most_samples)
    : m_scene(scene), m_eye(eye), m_light(light), m_sheet(setup.sheet),
      m_pass(pass_setup(scene, lattice_of(setup), eye, shadows, most_samples), light) {}

core::Pass* RadiosityRun::begin(RadiosityStore* store) {
  if (!store) return &m_pass;
  SavedRadiosity saved = store->pass(*m_scene.settings().radiosity, m_eye);
  m_file = store->used();
  if (!saved.cache) {
    m_pass.begin_with(store->samples());
    return &m_pass;
  }
  m_light.irradiance = std::move(saved.cache);
  m_saved = std::move(saved.report);
  return nullptr;
}

void RadiosityRun::keep(RadiosityStore& store) const {
  store.keep(*m_light.irradiance, m_pass.report());
}

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
  const core::RadiosityReport& report = this->report();
  std::ostringstream out;
  out << "Samples of radiosity";
  if (!m_file.empty())
    out << (m_saved ? ", of the pass in '" : ", besides those in '") << m_file << "'";
  out << "\n  level" << std::setw(kColumn) << "places";
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
  for (const core::RadiosityReport::Level& level : report().levels) {
    nlohmann::json depths = nlohmann::json::array();
    for (const core::GatherCounts& depth : level.depths) {
      depths.push_back({{"queries", depth.queries},
                        {"samples", depth.gathers},
                        {"rays", depth.rays},
                        {"not_kept", depth.not_kept}});
    }
    levels.push_back({{"places", level.places}, {"depths", depths}});
  }
  nlohmann::json out{{"levels", levels},
                     {"sees_every_pixel", report().sees_pixels},
                     {"bytes", m_light.irradiance->bytes()},
                     {"is_kept_pass", m_saved.has_value()}};
  if (!m_file.empty()) out["from_file"] = m_file;
  return out;
}

}  // namespace lentray::tool
