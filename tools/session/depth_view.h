// --depth-view: a lens sheet and what it shows, seen from above, as an SVG file that holds all it
// needs. Lengths are scene units: x along the sheet's row of lenses, depth behind the sheet
// upwards. What lies farther away than a few times the sheet's size is cut. Text is UTF-8. One
// thread.
#pragma once

#include <string>

#include "camera/depth_survey.h"
#include "camera/lenticular.h"

namespace lentray::tool {

/// `title`: the scene's name.
std::string depth_view(const camera::Lenticular& sheet, const camera::DepthSurvey& seen,
                       const std::string& title);

}  // namespace lentray::tool
