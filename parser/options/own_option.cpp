#include "parser/options/own_option.h"

#include <algorithm>
#include <cctype>

#include "parser/options/ini.h"

namespace lentray::parser {

std::string long_name(std::string_view name) {
  std::string out = "--";
  for (const unsigned char c : name) out += c == '_' ? '-' : static_cast<char>(std::tolower(c));
  return out;
}

std::optional<OwnOption> own_option(const std::vector<std::string>& words, std::size_t& at,
                                    std::span<const std::string_view> names) {
  const std::string& word = words[at];
  const std::size_t equals = word.find('=');
  const std::string name = word.substr(0, equals);
  const bool is_long = name.starts_with("--");
  if (!is_long && equals == std::string::npos) return std::nullopt;
  const auto row = std::ranges::find_if(names, [&](std::string_view known) {
    return is_long ? name == long_name(known) : same_word(name, known);
  });
  if (row == names.end()) return std::nullopt;
  OwnOption out{static_cast<std::size_t>(row - names.begin()), {}};
  out.given.shown = word;
  if (equals != std::string::npos) {
    out.given.value = unquoted(word.substr(equals + 1));
    return out;
  }
  if (at + 1 >= words.size()) throw OptionError(name + " needs a value");
  out.given.value = words[++at];
  out.given.shown += " " + words[at];
  return out;
}

}  // namespace lentray::parser
