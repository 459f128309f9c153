// What is said of the samples of radiosity in the form of POV-Ray 3.7.0. Pure.
// Source: stock's lines with standard error in a pipe. Lines about its octree have no like here.
#pragma once

#include <string>

#include "core/pass/radiosity_pass.h"

namespace lentray::tool {

std::string stock_radiosity_text(const core::RadiosityReport& report);

}  // namespace lentray::tool
