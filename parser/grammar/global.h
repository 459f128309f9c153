// global_settings { ... }. Source: reference manual 3.7, "Global Settings".
#pragma once

#include "parser/descriptions/global.h"
#include "parser/grammar/context.h"
#include "parser/interpreter/parser.h"

namespace lentray::parser {

/// The keyword is consumed; adds to what earlier blocks said.
void parse_global_settings(Parser& parser, Context& context, GlobalDesc& global);
/// `max_trace_level N`, also outside the block in old scenes; the keyword is consumed.
void parse_max_trace_level(Parser& parser, GlobalDesc& global);

}  // namespace lentray::parser
