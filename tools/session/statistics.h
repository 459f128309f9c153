// What a run reports of itself as JSON: Statistics_File, docs/statistics.md. Pure.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "core/scene/scene.h"
#include "shadow/report.h"
#include "tools/session/camera_setup.h"

namespace lentray::tool {

nlohmann::json statistics(const shadow::RunReport& report, const CameraSetup& camera,
                          const core::SceneSettings& settings);

}  // namespace lentray::tool
