// The statements of the scene level: text -> SceneDesc.
#pragma once

#include <string>

#include "parser/descriptions/scene.h"
#include "parser/grammar/productions.h"
#include "parser/interpreter/parser.h"

namespace lentray::parser {

/// Reads the file that `parser` has opened to its end. `grammar` is what the parser was made with.
SceneDesc parse_scene(Parser& parser, Grammar& grammar);

}  // namespace lentray::parser
