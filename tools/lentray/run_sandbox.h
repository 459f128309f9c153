// The sandbox of a run with Restrict_IO=On (docs/security.md): the system lets it open what the rules permit, what the
// user's own words name, and what the program itself needs, and nothing else. Beneath the rules, should a reader of
// pictures or fonts be taken over by what it reads. Errors: none; what is missing is told.
#pragma once

#include <string>

#include "parser/options/options.h"

namespace lentray::tool {

/// To be called before the first thread is started and anything of the scene is read. Returns why there is no sandbox,
/// or not all of it; empty: there is, or the run is not restricted.
std::string enter_sandbox(const parser::RenderOptions& options);

}  // namespace lentray::tool
