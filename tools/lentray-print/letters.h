// Letters of single lines, as plotters draw them: they need no font file, and look the same in every kind of file.
// ASCII; any other byte is an empty box. Units: mm. Errors: none. Pure.
#pragma once

#include <string_view>
#include <vector>

#include "tools/lentray-print/page.h"

namespace lentray::print {

/// `height`: of capital letters.
double text_width(std::string_view text, double height);
std::vector<Stroke> text_strokes(std::string_view text, Point foot, double height);

}  // namespace lentray::print
