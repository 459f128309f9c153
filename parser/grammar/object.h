// Object statements: text -> ObjectDesc.
#pragma once

#include "parser/descriptions/object.h"
#include "parser/grammar/context.h"
#include "parser/interpreter/parser.h"

namespace lentray::parser {

/// An object statement (`sphere { ... }`, `union { ... }`, an identifier of one, `object { ... }`)
/// if one is next; null and nothing consumed otherwise.
Ref<ObjectDesc> accept_object(Parser& parser, Context& context);
/// The same, and a message if there is none.
Ref<ObjectDesc> expect_object(Parser& parser, Context& context);
/// Whether the next token starts an object statement.
bool at_object(Parser& parser);
/// The words that start one, for messages.
std::string object_words();

}  // namespace lentray::parser
