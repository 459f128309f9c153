// light_source and light_group. Source: reference manual 3.7, "Light Source", "Light Groups".
#pragma once

#include "parser/descriptions/object.h"
#include "parser/grammar/context.h"
#include "parser/interpreter/parser.h"

namespace lentray::parser {

/// The keyword is consumed; `where` is its place.
Ref<ObjectDesc> parse_light_source(Parser& parser, Context& context, const Location& where);
Ref<ObjectDesc> parse_light_group(Parser& parser, Context& context, const Location& where);

}  // namespace lentray::parser
