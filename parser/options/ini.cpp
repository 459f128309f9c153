#include "parser/options/ini.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "core/base/joined.h"
#include "core/base/trimmed.h"
#include "parser/files/files.h"

namespace lentray::parser {
namespace {

std::string_view trimmed(std::string_view text) { return core::trimmed(text, " \t\r\n\f\v"); }

/// A line up to its comment, which ; or # begins; quotes protect both.
std::string_view without_comment(std::string_view line) {
  char quote = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (quote != 0) {
      if (c == quote) quote = 0;
    } else if (c == '"' || (c == '\'' && line.find('\'', i + 1) != std::string_view::npos)) {
      quote = c;
    } else if (c == ';' || c == '#') {
      return line.substr(0, i);
    }
  }
  return line;
}

/// Takes the first word off a line, up to a blank outside quotes; quotes stay.
std::string_view take_word(std::string_view& line) {
  char quote = 0;
  std::size_t end = 0;
  for (; end < line.size(); ++end) {
    const char c = line[end];
    if (quote == 0 && std::isspace(static_cast<unsigned char>(c))) break;
    if (quote == c)
      quote = 0;
    else if (quote == 0 && (c == '"' || c == '\''))
      quote = c;
  }
  const std::string_view word = line.substr(0, end);
  line = trimmed(line.substr(end));
  return word;
}

std::optional<std::string> label_of(std::string_view line) {
  if (line.empty() || line.front() != '[') return std::nullopt;
  const std::size_t end = line.find(']');
  if (end == std::string_view::npos) return std::nullopt;
  return std::string(trimmed(line.substr(1, end - 1)));
}

bool begins_switch(std::string_view text) { return text.front() == '+' || text.front() == '-'; }

IniLine option_of(std::string_view text, std::size_t equals, int number) {
  return {IniLine::Kind::kOption, number, std::string(trimmed(text.substr(0, equals))),
          unquoted(text.substr(equals + 1))};
}

/// Switches, behind which one Name=Value may stand.
void append_switches(std::string_view line, int number, std::vector<IniLine>& out) {
  while (!line.empty()) {
    const std::string_view rest = line;
    const std::string_view word = take_word(line);
    const std::size_t equals = word.find('=');
    if (!begins_switch(word) && equals != std::string_view::npos) {
      out.push_back(option_of(rest, equals, number));
      return;
    }
    out.push_back({IniLine::Kind::kSwitch, number, std::string(word), {}});
  }
}

void append_line(std::string_view line, int number, std::vector<IniLine>& out) {
  if (begins_switch(line)) {
    append_switches(line, number, out);
    return;
  }
  const std::size_t equals = line.find('=');
  if (equals != std::string_view::npos) {
    out.push_back(option_of(line, equals, number));
    return;
  }
  out.push_back({IniLine::Kind::kNested, number, unquoted(line), {}});
}

/// Calls back with every line that is not blank, comments and blanks around it removed.
template <typename Visit>
void for_lines(std::string_view text, Visit visit) {
  if (text.substr(0, 3) == "\xEF\xBB\xBF") text.remove_prefix(3);
  int number = 0;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
    ++number;
    const std::string_view line = trimmed(without_comment(text.substr(0, end)));
    if (!line.empty()) visit(line, number);
    const bool pair = end + 1 < text.size() && text[end] == '\r' && text[end + 1] == '\n';
    text.remove_prefix(std::min(text.size(), end + (pair ? 2 : 1)));
  }
}

}  // namespace

bool is_switch(std::string_view word) { return word.size() > 1 && begins_switch(word); }

bool is_ini(std::string_view word) {
  return same_word(std::filesystem::path(ini_name(word).file).extension().string(), ".ini");
}

bool same_word(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](unsigned char x, unsigned char y) {
    return std::tolower(x) == std::tolower(y);
  });
}

std::string unquoted(std::string_view text) {
  text = trimmed(text);
  if (text.size() >= 2 && (text.front() == '"' || text.front() == '\'') &&
      text.back() == text.front()) {
    text = text.substr(1, text.size() - 2);
  }
  return std::string(text);
}

IniName ini_name(std::string_view text) {
  IniName name;
  text = trimmed(text);
  if (!text.empty() && text.back() == ']') {
    if (const std::size_t open = text.rfind('['); open != std::string_view::npos && open > 0) {
      name.label = std::string(trimmed(text.substr(open + 1, text.size() - open - 2)));
      name.has_label = true;
      text = text.substr(0, open);
    }
  }
  name.file = unquoted(text);
  return name;
}

IniSection ini_lines(std::string_view text, const std::string& file, const IniName& name) {
  IniSection out;
  out.is_there = !name.has_label;
  // What stands before the first label holds for every section.
  bool reading = true;
  for_lines(text, [&](std::string_view line, int number) {
    if (line.front() == '[') {
      const auto label = label_of(line);
      if (!label) {
        throw OptionError(file + ":" + std::to_string(number) + ": a section label lacks its ]");
      }
      reading = name.has_label && same_word(*label, name.label);
      out.is_there = out.is_there || reading;
      return;
    }
    if (reading) append_line(line, number, out.lines);
  });
  return out;
}

std::vector<std::string> ini_labels(std::string_view text) {
  std::vector<std::string> out;
  for_lines(text, [&](std::string_view line, int) {
    if (auto label = label_of(line)) out.push_back(std::move(*label));
  });
  return out;
}

std::string ini_file_text(const std::string& path) {
  const auto text = disk_files().read_scene(path);
  if (!text) throw OptionError("cannot read the INI file '" + path + "'");
  return *text;
}

IniSection read_ini(std::string_view text, const std::string& path, const IniName& name,
                    std::vector<std::string>& warnings) {
  IniSection out = ini_lines(text, path, name);
  if (out.is_there) return out;
  const std::string known = core::joined(ini_labels(text));
  warnings.push_back("'" + path + "' has no section [" + name.label + "]" +
                     (known.empty() ? "" : ": there are " + known));
  return out;
}

}  // namespace lentray::parser
