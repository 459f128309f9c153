// What a run prints at its end. Pure.
#pragma once

#include <string>

#include "shadow/report.h"

namespace lentray::tool {

/// Lines; `output` is the picture's file, or empty.
std::string summary(const shadow::RunReport& report, const std::string& output);

}  // namespace lentray::tool
