// Fields of CSV files. Pure functions.
#pragma once

#include <string>

namespace lentray::tool {

/// Up to 12 digits, so that 0.1 * 3 is 0.3.
std::string number_text(double value);
/// In quotes where it must be (RFC 4180).
std::string csv_field(const std::string& text);

}  // namespace lentray::tool
