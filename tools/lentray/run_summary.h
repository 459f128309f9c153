// What a run prints at its end. Pure.
#pragma once

#include <string>

#include "parser/options/options.h"
#include "shadow/report.h"

namespace lentray::tool {

/// Lines; `output` is the picture's file, or empty.
std::string summary(const parser::RenderOptions& options, const shadow::RunReport& report,
                    const std::string& output);

/// Why a run makes no picture, and who said so.
std::string no_picture(const parser::RenderOptions& options);

}  // namespace lentray::tool
