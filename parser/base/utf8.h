// Names of files in texts that must be UTF-8, such as JSON. A name is bytes, which may be no UTF-8.
//
// A byte b that is no part of a character becomes the character U+EF00 + b (U+EF80 to U+EFFF),
// and so do the bytes of these characters themselves where a name has them. Every name has one
// such text, and no two names have the same. Pure functions.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace lentray::parser {

/// Bytes of the UTF-8 character that begins at `at`; 0: none does.
std::size_t utf8_length(std::string_view text, std::size_t at);

/// A text of that is UTF-8, as it is where it is one.
std::string utf8_of_bytes(std::string_view bytes);
/// The bytes again.
std::string bytes_of_utf8(std::string_view text);

}  // namespace lentray::parser
