#include "parser/base/text.h"

#include <cmath>

namespace lentray::parser {
namespace {

bool continues(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

}  // namespace

std::size_t count_characters(std::string_view text) {
  std::size_t count = 0;
  for (const char c : text) count += continues(c) ? 0 : 1;
  return count;
}

std::string substring(std::string_view text, std::size_t first, std::size_t count) {
  const auto offset = [&](std::size_t character) {
    std::size_t i = 0;
    for (std::size_t seen = 0; i < text.size(); ++i) {
      if (!continues(text[i]) && seen++ == character) break;
    }
    return i;
  };
  const std::size_t begin = offset(first);
  return std::string(text.substr(begin, offset(first + count) - begin));
}

double first_character(std::string_view text) {
  if (text.empty()) return 0.0;
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned lead = byte(0);
  if (lead >= 0xE0 && lead < 0xF0 && text.size() > 2 && continues(text[1]) && continues(text[2])) {
    return ((lead & 0x0Fu) << 12) | ((byte(1) & 0x3Fu) << 6) | (byte(2) & 0x3Fu);
  }
  if (lead >= 0xC0 && lead < 0xE0 && text.size() > 1 && continues(text[1])) {
    return ((lead & 0x1Fu) << 6) | (byte(1) & 0x3Fu);
  }
  return lead;
}

std::u32string characters_of(std::string_view text) {
  std::u32string out;
  while (!text.empty()) {
    out += static_cast<char32_t>(first_character(text));
    text.remove_prefix(1);
    while (!text.empty() && continues(text.front())) text.remove_prefix(1);
  }
  return out;
}

double character_difference(std::string_view a, std::string_view b) {
  std::size_t i = 0;
  while (i < a.size() && i < b.size() && a[i] == b[i]) ++i;
  while (i > 0 && ((i < a.size() && continues(a[i])) || (i < b.size() && continues(b[i])))) --i;
  return first_character(a.substr(i)) - first_character(b.substr(i));
}

std::string encode_character(unsigned code) {
  std::string out;
  if (code < 0x80) {
    out += static_cast<char>(code);
  } else if (code < 0x800) {
    out += static_cast<char>(0xC0 | (code >> 6));
    out += static_cast<char>(0x80 | (code & 0x3F));
  } else {
    out += static_cast<char>(0xE0 | (code >> 12));
    out += static_cast<char>(0x80 | ((code >> 6) & 0x3F));
    out += static_cast<char>(0x80 | (code & 0x3F));
  }
  return out;
}

bool append_substring(std::string& text, std::string_view whole, double first, double count) {
  first = std::trunc(first);
  count = std::trunc(count);
  const auto length = static_cast<double>(count_characters(whole));
  if (!(first >= 1.0 && count >= 0.0 && first + count - 1.0 <= length)) return false;
  text += substring(whole, static_cast<std::size_t>(first - 1), static_cast<std::size_t>(count));
  return true;
}

void change_case(std::string& text, std::size_t start, bool upper) {
  for (std::size_t i = start; i < text.size(); ++i) {
    char& c = text[i];
    if (upper && c >= 'a' && c <= 'z') c = static_cast<char>(c - 32);
    if (!upper && c >= 'A' && c <= 'Z') c = static_cast<char>(c + 32);
  }
}

std::string to_ascii(std::string text) {
  if (is_ascii(text)) return text;
  std::size_t out = 0;
  for (const char c : text) {
    if (continues(c)) continue;
    text[out++] = static_cast<unsigned char>(c) > 0x7F ? ' ' : c;
  }
  text.resize(out);
  return text;
}

}  // namespace lentray::parser
