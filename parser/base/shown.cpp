#include "parser/base/shown.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>

#include "parser/base/utf8.h"

namespace lentray::parser {
namespace {

bool is_control(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; }

/// Bytes behind the first of a character of UTF-8.
bool is_inside_character(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

/// What stands at a place of a text: a character of UTF-8, or a byte that is none.
struct Letter {
  std::size_t size = 1;
  std::uint32_t code = 0;
  bool is_utf8 = false;
};

Letter letter_at(std::string_view text, std::size_t i) {
  const auto first = static_cast<unsigned char>(text[i]);
  const std::size_t size = utf8_length(text, i);
  if (size <= 1) return {1, first, size == 1};
  std::uint32_t code = first & (0x7Fu >> size);
  for (std::size_t k = 1; k < size; ++k)
    code = code << 6 | (static_cast<unsigned char>(text[i + k]) & 0x3F);
  return {size, code, true};
}

/// C1, which terminals heed too, and bytes that are no UTF-8.
bool is_unshowable(const Letter& letter) {
  return !letter.is_utf8 || (letter.code >= 0x80 && letter.code < 0xA0);
}

/// Characters that turn the direction of what follows: text is then shown in another order than it has.
bool turns_direction(const Letter& letter) {
  const std::uint32_t c = letter.code;
  return letter.is_utf8 && ((c >= 0x202A && c <= 0x202E) || (c >= 0x2066 && c <= 0x2069) ||
                            c == 0x200E || c == 0x200F || c == 0x061C);
}

std::string escaped(std::string_view text, std::string_view kept) {
  std::string shown;
  shown.reserve(text.size());
  for (std::size_t i = 0; i < text.size();) {
    const Letter letter = letter_at(text, i);
    char escape[12] = "";
    if (turns_direction(letter)) {
      std::snprintf(escape, sizeof escape, "\\u%04x", letter.code);
    } else if (is_unshowable(letter) ||
               (is_control(text[i]) && kept.find(text[i]) == std::string_view::npos)) {
      std::snprintf(escape, sizeof escape, "\\x%02x", letter.code);
    }
    shown += escape[0] != 0 ? std::string_view(escape) : text.substr(i, letter.size);
    i += letter.size;
  }
  return shown;
}

}  // namespace

std::string shown_name(std::string_view name) {
  constexpr std::size_t kMost = 400;
  if (name.size() <= kMost) return escaped(name, "");
  return escaped(name.substr(0, kMost), "") + "...";
}

std::string shown_bytes(std::string_view text) {
  std::string shown;
  shown.reserve(text.size());
  for (std::size_t i = 0; i < text.size();) {
    const Letter letter = letter_at(text, i);
    char escape[8] = "";
    if (!letter.is_utf8) std::snprintf(escape, sizeof escape, "\\x%02x", letter.code & 0xFF);
    shown += escape[0] != 0 ? std::string_view(escape) : text.substr(i, letter.size);
    i += letter.size;
  }
  return shown;
}

std::string shown_text(std::string_view text) { return escaped(text, "\n\t\r\b"); }

std::string shown_message(std::string text) {
  constexpr std::size_t kMost = 4000;
  if (text.size() <= kMost) return text;
  return text.substr(0, kMost) + "... (" + std::to_string(text.size()) + " bytes)";
}

ShownLine shown_line(std::string_view line, std::size_t column) {
  constexpr std::size_t kBefore = 100, kMost = 160;
  ShownLine out;
  const std::size_t at = std::min(column > 0 ? column - 1 : 0, line.size());
  std::size_t begin = line.size() > kMost && at > kBefore ? at - kBefore : 0;
  while (begin < at && is_inside_character(line[begin])) ++begin;
  std::size_t end = std::min(line.size(), begin + kMost);
  while (end < line.size() && end > at && is_inside_character(line[end])) --end;
  if (begin > 0) out.line = out.indent = "...";
  std::fill(out.indent.begin(), out.indent.end(), ' ');
  for (std::size_t i = begin; i < end;) {
    const Letter letter = letter_at(line, i);
    const bool is_hidden = is_unshowable(letter) || turns_direction(letter) ||
                           (is_control(line[i]) && line[i] != '\t');
    const std::string_view shown = is_hidden ? "?" : line.substr(i, letter.size);
    out.line += shown;
    // As many blanks as bytes.
    for (std::size_t k = 0; k < shown.size() && i + k < at; ++k)
      out.indent += shown == "\t" ? '\t' : ' ';
    i += letter.size;
  }
  for (std::size_t i = std::max(end, begin); i < at; ++i) out.indent += ' ';
  if (end < line.size()) out.line += "...";
  return out;
}

}  // namespace lentray::parser
