// Radiosity of a scene's pictures: the pass before them, or one that was kept, and what is reported of it. All that
// looks at one lens sheet, the sheet itself, its views and quilts of them, shares the pass over the sheet. One
// thread.
#pragma once

#include <cstdint>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "core/pass/radiosity_pass.h"
#include "tools/session/camera_setup.h"
#include "tools/session/radiosity_store.h"

namespace lentray::tool {

class RadiosityRun {
 public:
  /// Of a scene with radiosity. All but the setup outlives it; `shadows` the pass's run. `light` gets the
  /// samples, `most_samples` at most; 0: as the memory allows.
  RadiosityRun(const core::Scene& scene, const CameraSetup& camera, const core::Vec3& eye,
               const core::ShadowTesterFactory& shadows, core::Illumination& light,
               std::uint64_t most_samples);
  /// The pass that is to be run; null: one that was kept takes its place. `store`: null: there is none.
  core::Pass* begin(RadiosityStore* store);
  /// The pass has been run.
  void keep(RadiosityStore& store) const;
  /// Whether a picture of that camera is lit by it too.
  bool serves(const CameraSetup& camera) const { return m_sheet && m_sheet == camera.sheet; }

  /// What a user may want to know of the light that it left; empty: nothing.
  std::string warning() const;
  const core::RadiosityReport& report() const { return m_saved ? *m_saved : m_pass.report(); }
  /// The samples by level and depth, as a table.
  std::string text() const;
  /// The same and more.
  nlohmann::json json() const;

 private:
  const core::Scene& m_scene;
  const core::Vec3 m_eye;
  core::Illumination& m_light;
  const std::shared_ptr<const camera::Lenticular> m_sheet;  ///< null: an ordinary picture
  core::RadiosityPass m_pass;
  std::optional<core::RadiosityReport> m_saved;  ///< of a pass that was kept
  std::string m_file;                            ///< that was used; empty: none
};

}  // namespace lentray::tool
