#include "parser/options/ini_lines.h"

#include <algorithm>
#include <charconv>
#include <vector>

#include "parser/options/ini.h"

namespace lentray::parser {
namespace {

/// `written` behind the name is read as that value.
bool is_read_as(std::string_view name, const std::string& written, std::string_view value) {
  // Stock's readers, and people's editors, make something else of control characters.
  const auto is_control = [](char c) { return static_cast<unsigned char>(c) < ' ' && c != '\t'; };
  if (std::ranges::any_of(value, is_control)) return false;
  const std::vector<IniLine> lines =
      ini_lines(std::string(name) + "=" + written, "", {"", "", false}).lines;
  return lines.size() == 1 && lines[0].text == name && lines[0].value == value;
}

}  // namespace

void IniLines::line(std::string_view name, std::string_view value) {
  m_are_held = m_are_held && is_read_as(name, std::string(value), value);
  m_text.append(name).append("=").append(value).append("\n");
}

void IniLines::add(std::string_view name, const std::string& value) {
  if (value.empty()) return;
  std::string written = '"' + value + '"';
  if (!is_read_as(name, written, value)) written = "'" + value + "'";
  m_are_held = m_are_held && is_read_as(name, written, value);
  m_text.append(name).append("=").append(written).append("\n");
}

std::string IniLines::text_of(double value) {
  char digits[32];
  return {digits, std::to_chars(digits, digits + sizeof digits, value).ptr};
}

}  // namespace lentray::parser
