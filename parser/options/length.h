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

/// Of what is printed: 0 to 100 m; and greater than 0.
double size_mm(const GivenOption& given);
double positive_size_mm(const GivenOption& given);

/// A width and a height, mm.
struct Extent {
  double width = 0.0, height = 0.0;
};
/// "200x100mm" or "8inx100mm": a unit that the width lacks is the height's. Greater than 0, 100 m at most.
Extent extent_mm(const GivenOption& given);

/// A length in the scene's own units, 0 or more: a plain number, for a scene has no mm. `instead`: an
/// option that takes mm, for the message.
double scene_length(const GivenOption& given, const char* instead);

}  // namespace lentray::parser
