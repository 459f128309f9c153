#include "parser/base/shown.h"

#include <algorithm>
#include <cstdio>

namespace lentray::parser {
namespace {

bool is_control(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; }

/// C1, which terminals heed too: two bytes of UTF-8.
bool is_upper_control(std::string_view text, std::size_t i) {
  if (text[i] != '\xC2' || i + 1 >= text.size()) return false;
  const auto next = static_cast<unsigned char>(text[i + 1]);
  return next >= 0x80 && next < 0xA0;
}

std::string escaped(std::string_view text, std::string_view kept) {
  std::string shown;
  shown.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool is_upper = is_upper_control(text, i);
    if (!is_upper && (!is_control(text[i]) || kept.find(text[i]) != std::string_view::npos)) {
      shown += text[i];
      continue;
    }
    if (is_upper) ++i;
    char escape[8];
    std::snprintf(escape, sizeof escape, "\\x%02x", static_cast<unsigned char>(text[i]));
    shown += escape;
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
    const bool is_upper = is_upper_control(line, i);
    if (is_upper) ++i;
    const char shown = is_upper || (is_control(line[i]) && line[i] != '\t') ? '?' : line[i];
    out.line += shown;
    if (i < at) out.indent += shown == '\t' ? '\t' : ' ';
  }
  for (std::size_t i = std::max(end, begin); i < at; ++i) out.indent += ' ';
  if (end < line.size()) out.line += "...";
  return out;
}

}  // namespace lentray::parser
