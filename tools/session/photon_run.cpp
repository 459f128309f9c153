#include "tools/session/photon_run.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/image/file_swap.h"
#include "core/image/writer.h"
#include "core/image/written_bytes.h"
#include "core/photon/photon_file.h"
#include "core/photon/photon_map.h"
#include "core/scene/scene.h"

namespace lentray::tool {

PhotonRun::PhotonRun(const core::Scene& scene, core::Illumination& light)
    : m_scene(scene), m_light(light) {
  const core::SceneSettings& settings = scene.settings();
  if (settings.loaded_photons) {
    light.photons = core::make_photon_light(*settings.loaded_photons, *settings.photons);
  } else {
    m_pass.emplace(scene, light);
  }
}

const std::string& PhotonRun::file() const { return m_scene.settings().photons->save_file; }

std::string PhotonRun::save() const {
  const std::string& name = file();
  if (name.empty() || !m_pass) return {};
  const core::PhotonLight& light = *m_light.photons;
  if (light.surface.is_empty() && light.media.is_empty()) {
    return "there are no photons to save in '" + name + "'";
  }
  try {
    core::FileSwap swap(name);
    if (const std::string why = core::count_written(bytes()); !why.empty())
      throw core::ImageError("cannot write " + core::shown_place(name) + ": " + why);
    errno = 0;
    std::ofstream out(swap.temporary(), std::ios::binary);
    core::write_photon_file(out, light.surface.tree().photons(), light.media.tree().photons());
    out.close();
    if (!out) {
      throw core::ImageError("cannot write " + core::shown_place(name) + ": " +
                             std::strerror(errno != 0 ? errno : EIO));
    }
    swap.commit();
  } catch (const core::ImageError& error) {
    return std::string("the photons are not saved: ") + error.what();
  }
  return {};
}

std::string PhotonRun::warning() const {
  if (!m_pass) return {};
  const core::PhotonReport& report = m_pass->report();
  if (report.is_full) {
    return "photons: shooting ended with " + std::to_string(core::PhotonPass::kMostPhotons) +
           " of them, the most that are kept; a greater spacing or a smaller count shoots fewer";
  }
  if (report.surface + report.media == 0)
    return "photons: none of those that were shot lights anything";
  return {};
}

std::string PhotonRun::text() const {
  constexpr int kColumn = 12;
  std::ostringstream out;
  const auto line = [&](const char* what, double number) {
    out << std::setw(22) << std::left << what << std::setw(kColumn) << std::right << number << '\n';
  };
  out << std::setprecision(12) << (m_pass ? "Photons\n" : "Photons (loaded)\n");
  const core::PhotonLight& light = *m_light.photons;
  if (m_pass) line("  shot", static_cast<double>(m_pass->report().shot));
  line("  on surfaces", static_cast<double>(light.surface.tree().size()));
  line("  in media", static_cast<double>(light.media.tree().size()));
  out << std::setprecision(6);
  if (!light.surface.is_empty()) line("  radius, surfaces", light.surface.radius());
  if (!light.media.is_empty()) line("  radius, media", light.media.radius());
  return out.str();
}

std::uint64_t PhotonRun::bytes() const {
  const core::PhotonLight& light = *m_light.photons;
  return (light.surface.tree().size() + light.media.tree().size()) * sizeof(core::Photon);
}

nlohmann::json PhotonRun::json() const {
  const core::PhotonLight& light = *m_light.photons;
  nlohmann::json out{{"loaded", !m_pass},
                     {"surface", light.surface.tree().size()},
                     {"media", light.media.tree().size()},
                     {"surface_radius", light.surface.radius()},
                     {"media_radius", light.media.radius()}};
  if (m_pass) {
    out["shot"] = m_pass->report().shot;
    out["units"] = m_pass->report().units;
  }
  return out;
}

}  // namespace lentray::tool
