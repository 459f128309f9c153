// Lengths that carry their unit, as options of printed things take them: "12.5mm", "2cm", "0.3m", "8.5in".
// Units: the results are millimetres. Errors: OptionError, worded for the user. Pure.
#pragma once

#include "parser/options/option_values.h"

namespace lentray::parser {

/// A width and a height, mm.
struct Extent {
  double width = 0.0, height = 0.0;
};

/// 0 or more, 100 m at most. A number without a unit is refused: it may be meant in any.
double length_in_mm(const GivenOption& given);
/// The same, greater than 0.
double positive_length_in_mm(const GivenOption& given);
/// "200x100mm" or "8inx100mm": a unit that the width lacks is the height's.
Extent extent_in_mm(const GivenOption& given);

}  // namespace lentray::parser
