// Numbers and sizes for the lines that lentray-print says. Pure.
#pragma once

#include <string>

namespace lentray::print {

/// With so many decimals at most.
std::string short_number(double value, int decimals = 3);
/// "25.4 x 12.7 mm"
std::string size_text(double width, double height);

}  // namespace lentray::print
