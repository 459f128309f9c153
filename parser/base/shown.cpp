#include "parser/base/shown.h"

#include <algorithm>
#include <cstdio>

#include "parser/base/utf8.h"

namespace lentray::parser {
namespace {

bool is_control(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; }

/// C1, which terminals heed too: two bytes of UTF-8.
bool is_upper_control(std::string_view text, std::size_t i) {
  if (text[i] != '\xC2' || i + 1 >= text.size()) return false;
  const auto next = static_cast<unsigned char>(text[i + 1]);
  return next >= 0x80 && next < 0xA0;
}

/// U+200E, U+200F, U+202A to U+202E, U+2066 to U+2069: their number; 0: the character is another.
unsigned direction_mark(std::string_view text, std::size_t i) {
  if (i + 2 >= text.size() || text[i] != '\xE2') return 0;
  const unsigned second = static_cast<unsigned char>(text[i + 1]);
  const unsigned third = static_cast<unsigned char>(text[i + 2]);
  const unsigned mark = 0x2000 + ((second & 0x3F) << 6) + (third & 0x3F);
  const bool is_one = mark == 0x200E || mark == 0x200F || (mark >= 0x202A && mark <= 0x202E) ||
                      (mark >= 0x2066 && mark <= 0x2069);
  return is_one ? mark : 0;
}

void append_escape(std::string& to, const char* how, unsigned number) {
  char escape[16];
  std::snprintf(escape, sizeof escape, how, number);
  to += escape;
}

std::string escaped(std::string_view text, std::string_view kept) {
  std::string shown;
  shown.reserve(text.size());
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = std::max<std::size_t>(utf8_length(text, i), 1);
    const bool is_kept = is_control(text[i]) && kept.find(text[i]) != std::string_view::npos;
    const bool is_none = utf8_length(text, i) == 0;
    if (const unsigned mark = direction_mark(text, i)) {
      append_escape(shown, "\\u%04x", mark);
    } else if (!is_kept && (is_none || is_control(text[i]) || is_upper_control(text, i))) {
      append_escape(shown, "\\x%02x", static_cast<unsigned char>(text[i + length - 1]));
    } else {
      shown.append(text.substr(i, length));
    }
    i += length;
  }
  return shown;
}

/// Bytes behind the first of a character of UTF-8.
bool is_inside_character(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

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
    const std::size_t length = utf8_length(text, i);
    if (length == 0) append_escape(shown, "\\x%02x", static_cast<unsigned char>(text[i]));
    shown.append(text.substr(i, length));
    i += std::max<std::size_t>(length, 1);
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
  for (std::size_t i = begin; i < end; ++i) {
    const std::size_t length = utf8_length(line, i);
    const bool is_mark = direction_mark(line, i) != 0;
    const bool is_none = length == 0 || (i + length > end && length > 1);
    if (is_mark || is_none || is_upper_control(line, i) ||
        (is_control(line[i]) && line[i] != '\t')) {
      out.line += '?';
      if (i < at) out.indent += ' ';
      if (!is_none) i += length - 1;
      continue;
    }
    out.line += line[i];
    if (i < at) out.indent += line[i] == '\t' ? '\t' : ' ';
  }
  for (std::size_t i = std::max(end, begin); i < at; ++i) out.indent += ' ';
  if (end < line.size()) out.line += "...";
  return out;
}

}  // namespace lentray::parser
