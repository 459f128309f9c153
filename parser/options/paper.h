// Sizes of paper, and of what is as large as it, by their names. Units: mm. Errors: OptionError. Pure.
// Source: ISO 216, ANSI/ASME Y14.1; a postcard is ISO's, A6.
#pragma once

#include <string>

#include "parser/options/length.h"

namespace lentray::parser {

/// "A5", "A5-landscape", "letter-portrait", or a width and a height: "100x75mm". A name alone is upright. Letter case is
/// ignored.
Extent paper_extent(const GivenOption& given);
/// For messages.
std::string paper_names();

}  // namespace lentray::parser
