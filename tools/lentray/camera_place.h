// Where an error of a camera comes from: the scene's camera statement, or the options that ask
// for a lens sheet.
#pragma once

#include "camera/lens_data.h"
#include "parser/options/options.h"
#include "tools/session/session.h"

namespace lentray::tool {

/// Throws parser::ParseError at the statement where that has a part in it, else
/// camera::CameraError; either names the options.
[[noreturn]] void fail_with_place(const camera::CameraError& error, Session& session,
                                  const parser::RenderOptions& options);

}  // namespace lentray::tool
