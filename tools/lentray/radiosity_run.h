// Radiosity of a run: the pass before its picture, and what is told of it.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "core/pass/radiosity_pass.h"
#include "parser/compile/camera.h"

namespace lentray::tool {

struct CameraSetup;

/// From where the lengths of reuse are measured: the camera's location; of a sheet that the scene has itself,
/// its width before its middle.
core::Vec3 radiosity_eye(const parser::CameraRequest& request);

class RadiosityRun {
 public:
  /// Without a pass for a scene without radiosity. All but the setup outlives the pass's run; `light` gets
  /// the samples.
  RadiosityRun(const core::Scene& scene, const CameraSetup& camera, const core::Vec3& eye,
               const core::ShadowTesterFactory& shadows, core::Illumination& light);
  /// Null: there is none.
  core::Pass* pass() { return m_pass ? &*m_pass : nullptr; }

  /// What a user may want to know of the light that it left; empty: nothing.
  std::string warning(const core::Illumination& light) const;
  /// The samples by level and depth, as a table; empty without radiosity.
  std::string text() const;
  /// The same and more; null without radiosity.
  nlohmann::json json() const;

 private:
  const core::Scene& m_scene;
  std::optional<core::RadiosityPass> m_pass{};
};

}  // namespace lentray::tool
