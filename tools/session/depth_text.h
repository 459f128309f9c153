// What is said and drawn of a lens sheet's depth. One thread.
#pragma once

#include <string>

#include "camera/depth_survey.h"
#include "tools/session/camera_setup.h"

namespace lentray::tool {

struct DepthText {
  std::string report;   ///< lines
  std::string drawing;  ///< SVG; empty unless it was asked for
};

/// Of a setup that has a lens sheet. `title` of the drawing; null: none is asked for.
DepthText depth_text(const CameraSetup& setup, const camera::DepthSurvey& seen,
                     const std::string* title);

}  // namespace lentray::tool
