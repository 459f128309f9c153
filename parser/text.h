// Characters of UTF-8 strings: counting, cutting, codes. Bytes that are no UTF-8 count as they come.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace lentray::parser {

std::size_t count_characters(std::string_view text);
/// `count` characters from number `first` (from 0); both must lie in the text.
std::string substring(std::string_view text, std::size_t first, std::size_t count);
/// The code of the first character; 0 if there is none.
double first_character(std::string_view text);
/// The difference of the codes of the first characters that differ, as stock's strcmp(); 0: equal.
double character_difference(std::string_view a, std::string_view b);
std::string encode_character(unsigned code);
/// With a space for each character that is not ASCII: what stock writes.
std::string to_ascii(std::string text);

bool is_ascii(std::string_view text);

/// Appends x as printf's %.0f has it, if x is a whole number that an int holds: most are. -0 is not.
bool append_whole(std::string& text, double x);

}  // namespace lentray::parser
