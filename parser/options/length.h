// Lengths in options: a number of mm, or a number with a unit behind it.
// Errors: OptionError that names the units. Any number of threads.
#pragma once

#include "parser/options/option_values.h"

namespace lentray::parser {

/// mm. Units: mm, cm, m, um, in, inch; letter case is ignored. A quotation mark is no unit, for shells
/// and INI files take it for the begin of a text.
double length_mm(const GivenOption& given);
/// The same, greater than 0.
double positive_length_mm(const GivenOption& given);

/// A length in the scene's own units, 0 or more: a plain number, for a scene has no mm. `instead`: an
/// option that takes mm, for the message.
double scene_length(const GivenOption& given, const char* instead);

}  // namespace lentray::parser
