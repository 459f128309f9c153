// --explain: what a scene needs of the renderer, as text.
#pragma once

#include <string>

#include "core/scene/scene.h"
#include "tools/session/camera_setup.h"

namespace lentray::tool {

std::string explanation(const core::Scene& scene, const CameraSetup& camera,
                        const std::vector<std::string>& not_rendered);

}  // namespace lentray::tool
