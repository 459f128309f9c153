// Where an error of a camera comes from: the scene's camera statement, or the options that ask
// for a lens sheet.
#pragma once

#include <optional>

#include "camera/lens_data.h"
#include "parser/descriptions/camera.h"
#include "parser/options/options.h"
#include "parser/source/diagnostics.h"

namespace lentray::tool {

/// Throws parser::ParseError at the statement where that has a part in it, else
/// camera::CameraError; either names the options.
[[noreturn]] void fail_with_place(const camera::CameraError& error,
                                  const std::optional<parser::CameraDesc>& camera,
                                  const parser::RenderOptions& options,
                                  parser::Diagnostics& diagnostics);

}  // namespace lentray::tool
