// Text of scenes and files as messages and the console show it: control characters as \x1b, which could forge lines
// or steer a terminal, marks that turn the direction of what follows as \u202e, bytes that are no UTF-8 as \xe9, and
// lengths that a reader can take in. Threads: any number.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace lentray::parser {

/// A name for messages, on one line.
std::string shown_name(std::string_view name);

/// The bytes that are no UTF-8 alone: for pages, which show the others themselves.
std::string shown_bytes(std::string_view text);

/// What a scene says (#debug and kin) for the console: ends of lines, tabs, backspaces and returns stay.
std::string shown_text(std::string_view text);

/// The beginning of a message that is longer than a screen.
std::string shown_message(std::string text);

/// The part of a line around a column, from 1, and the blanks before a caret below it; tabs stay tabs, so that the
/// caret lines up. Other control characters are '?', of one column.
struct ShownLine {
  std::string line, indent;
};
ShownLine shown_line(std::string_view line, std::size_t column);

}  // namespace lentray::parser
