// What a run tells of itself at its end: a summary for the reader, and the same and more as JSON (Statistics_File,
// docs/statistics.md). Pure functions.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "core/scene/scene.h"
#include "parser/options/options.h"
#include "shadow/report.h"
#include "tools/lentray/camera_setup.h"

namespace lentray::tool {

nlohmann::json statistics(const shadow::RunReport& report, const parser::RenderOptions& options,
                          const CameraSetup& camera, const core::SceneSettings& settings);

/// Lines; `output` is the picture's file, or empty.
std::string summary(const shadow::RunReport& report, const std::string& output);

}  // namespace lentray::tool
