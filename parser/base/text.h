// Characters of UTF-8 strings: counting, cutting, codes. Bytes that are no UTF-8 count as they come.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

namespace lentray::parser {

std::size_t count_characters(std::string_view text);
/// `count` characters from number `first` (from 0); both must lie in the text.
std::string substring(std::string_view text, std::size_t first, std::size_t count);
/// The code of the first character; 0 if there is none.
double first_character(std::string_view text);
/// The codes of all characters.
std::u32string characters_of(std::string_view text);
/// The difference of the codes of the first characters that differ, as stock's strcmp(); 0: equal.
double character_difference(std::string_view a, std::string_view b);
/// chr() knows it.
inline bool is_character(double code) { return code >= 0.0 && code < 65536.0; }
std::string encode_character(unsigned code);
/// substr(): `count` characters from number `first`, from 1. False, nothing appended, if there are
/// not so many.
bool append_substring(std::string& text, std::string_view whole, double first, double count);
/// strupr() and strlwr(), from byte `start` on: the letters of ASCII.
void change_case(std::string& text, std::size_t start, bool upper);
/// With a space for each character that is not ASCII: what stock writes.
std::string to_ascii(std::string text);

inline bool is_ascii(std::string_view text) {
  constexpr std::size_t kAtOnce = sizeof(std::uint64_t);
  std::uint64_t bits = 0, piece = 0;
  std::size_t i = 0;
  for (; i + kAtOnce <= text.size(); i += kAtOnce) {
    std::memcpy(&piece, text.data() + i, kAtOnce);
    bits |= piece;
  }
  piece = 0;
  if (i < text.size()) std::memcpy(&piece, text.data() + i, text.size() - i);
  return ((bits | piece) & 0x8080808080808080u) == 0;
}

}  // namespace lentray::parser
