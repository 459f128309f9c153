#include "parser/options/own_option.h"

#include <cctype>
#include <utility>

#include "parser/options/ini.h"

namespace lentray::parser {

std::string long_name(std::string_view name) {
  std::string out = "--";
  for (const unsigned char c : name) out += c == '_' ? '-' : static_cast<char>(std::tolower(c));
  return out;
}

std::optional<GivenOption> own_option(const std::vector<std::string>& words, std::size_t& at,
                                      std::string_view known) {
  const std::string& word = words[at];
  const std::size_t equals = word.find('=');
  const std::string name = word.substr(0, equals);
  const bool is_long = name.starts_with("--");
  if (!is_long && equals == std::string::npos) return std::nullopt;
  if (is_long ? name != long_name(known) : !same_word(name, known)) return std::nullopt;
  GivenOption given;
  given.shown = word;
  if (equals != std::string::npos) {
    given.value = unquoted(word.substr(equals + 1));
    return given;
  }
  if (at + 1 >= words.size()) throw OptionError(name + " needs a value");
  given.value = words[++at];
  given.shown += " " + words[at];
  return given;
}

std::filesystem::path file_name(const GivenOption& given, const char* what) {
  if (given.value.empty()) refuse(given, std::string("the name of a ") + what + " is expected");
  return given.value;
}

bool is_second(const GivenOption& given, const std::string& first, const std::string& second) {
  if (given.value != first && given.value != second) {
    refuse(given, "there are " + first + " and " + second);
  }
  return given.value == second;
}

}  // namespace lentray::parser
