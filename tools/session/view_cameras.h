// The cameras of a quilt's tiles, or of a lens sheet's views, as JSON for other programs:
// docs/views.md. One thread.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "tools/session/camera_setup.h"

namespace lentray::tool {

/// Of a setup that has a lens sheet. `scene`: its name, or empty.
nlohmann::ordered_json view_cameras(const CameraSetup& setup, const CameraOptions& options,
                                    const std::string& scene);

}  // namespace lentray::tool
