// camera { ... }, POV-Ray's kinds and this program's `lenticular`.
// Source: reference manual 3.7, "Camera".
#pragma once

#include "parser/descriptions/camera.h"
#include "parser/grammar/context.h"
#include "parser/interpreter/parser.h"

namespace lentray::parser {

/// The keyword is consumed. `start` is the camera the words change (#version 3.5 and later: the
/// default camera; before: the previous camera of the scene).
CameraDesc parse_camera(Parser& parser, Context& context, const CameraDesc& start);

}  // namespace lentray::parser
