// What may follow a shape inside its braces, the same for (nearly) every object.
// Source: reference manual 3.7, "Object Modifiers".
#pragma once

#include "parser/descriptions/object.h"
#include "parser/grammar/context.h"
#include "parser/interpreter/parser.h"

namespace lentray::parser {

/// Reads modifiers and the closing brace.
void parse_object_modifiers(Parser& parser, Context& context, ObjectDesc& object);

/// One modifier if one is next.
bool accept_object_modifier(Parser& parser, Context& context, ObjectDesc& object);

/// What stands behind `importance`.
double parse_importance(Parser& parser);

/// `photons { ... }` of an object or of a light, the keyword consumed.
void parse_photon_flags(Parser& parser, PhotonFlags& photons, bool of_light);

}  // namespace lentray::parser
