// What programs say, for rows: lines of bounded length without control characters. Pure functions.
#pragma once

#include <string>
#include <string_view>

namespace lentray::tool {

/// On one line, cut within a character at none.
std::string one_line(std::string_view text, std::size_t longest = 400);
/// The line of a program's output that says why it failed, in one line.
std::string last_error(std::string_view output);

}  // namespace lentray::tool
