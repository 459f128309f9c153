// Radiosity of a scene's pictures: the pass before them, and what is told of it. All that looks at one lens
// sheet, the sheet itself, its views and quilts of them, shares the pass over the sheet. One thread.
#pragma once

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "core/pass/radiosity_pass.h"
#include "parser/compile/camera.h"
#include "tools/session/camera_setup.h"

namespace lentray::tool {

/// From where the lengths of reuse are measured: the camera's location; of a sheet that the scene has itself,
/// its width before its middle.
core::Vec3 radiosity_eye(const parser::CameraRequest& request);

class RadiosityRun {
 public:
  /// Of a scene with radiosity. All but the setup outlives it; `shadows` the pass's run. `light` gets the
  /// samples.
  RadiosityRun(const core::Scene& scene, const CameraSetup& camera, const core::Vec3& eye,
               const core::ShadowTesterFactory& shadows, core::Illumination& light);
  core::Pass& pass() { return m_pass; }
  /// Whether a picture of that camera is lit by it too.
  bool serves(const CameraSetup& camera) const { return m_sheet && m_sheet == camera.sheet; }

  /// What a user may want to know of the light that it left; empty: nothing.
  std::string warning() const;
  /// The samples by level and depth, as a table.
  std::string text() const;
  /// The same and more.
  nlohmann::json json() const;

 private:
  const core::Scene& m_scene;
  const core::Illumination& m_light;
  const std::shared_ptr<const camera::Lenticular> m_sheet;  ///< null: an ordinary picture
  core::RadiosityPass m_pass;
};

}  // namespace lentray::tool
