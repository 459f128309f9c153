#include "tools/lentray-merge/arguments.h"

#include <algorithm>
#include <stdexcept>
#include <string_view>

#include "parser/options/ini.h"
#include "parser/options/own_option.h"

namespace lentray::merge {

using parser::GivenOption;
using parser::OptionError;

namespace {

std::vector<Rows> list_of(const GivenOption& given) {
  std::vector<Rows> all;
  for (std::size_t at = 0; at <= given.value.size();) {
    const std::size_t comma = std::min(given.value.find(',', at), given.value.size());
    try {
      all.push_back(rows_of(std::string_view(given.value).substr(at, comma - at)));
    } catch (const std::invalid_argument& e) {
      parser::refuse(given, e.what());
    }
    at = comma + 1;
  }
  return all;
}

constexpr parser::OwnOption<Arguments> kOptions[] = {
    {"Out", parser::set<&Arguments::out, parser::any_file>},
    {"Rows", parser::set<&Arguments::rows, list_of>},
};

/// What the options can only be judged on together.
void check(const Arguments& a) {
  if (a.parts.empty())
    throw OptionError("no parts are given; lentray-merge --help lists all options");
  if (a.out.empty()) throw OptionError("--out PICTURE is missing");
  if (!a.rows.empty() && a.rows.size() != a.parts.size()) {
    throw OptionError("--rows names " + std::to_string(a.rows.size()) + " parts, but there are " +
                      std::to_string(a.parts.size()));
  }
}

}  // namespace

Arguments parse_arguments(const std::vector<std::string>& words) {
  Arguments arguments;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string& word = words[i];
    if (parser::take_own_option(words, i, kOptions, arguments)) continue;
    if (word.starts_with("-")) {
      throw OptionError("unknown option '" + word.substr(0, word.find('=')) +
                        "'; there are --out --rows --help --version");
    } else {
      arguments.parts.emplace_back(word);
    }
  }
  check(arguments);
  return arguments;
}

std::string usage() {
  return R"(usage: lentray-merge PART... --out PICTURE [--rows FIRST-LAST,...]

Joins bands of a picture, rendered apart with +SR and +ER, into the picture.
It is the file that lentray writes when it renders the whole at once, byte for
byte: samples, gamma, resolution, lens data. Parts are PNG files of the whole
picture's size, as lentray writes them, black outside of their rows; their order
does not matter. Memory is taken for a few rows of each part.

Rows are those of --rows, or of a PNG file's text "lentray:rows", which programs
that cut pictures may write (lentray does not). Of other parts all rows that are
not black count. Parts may have rows in common: these must be equal.

  --out PICTURE          the picture, a PNG file; it appears when it is whole,
                         and what stood there before stays until then
  --rows FIRST-LAST,...  the rows of each part, in the order of the parts, counted
                         from 1 as +SR and +ER have them: 1-60,61-120. So rows
                         that are missing are not taken for black ones
  --help, --version

Examples:
  lentray a.pov +W320 +H240 +SR1 +ER120 +Oupper.png
  lentray a.pov +W320 +H240 +SR121 +ER240 +Olower.png
  lentray-merge upper.png lower.png --rows 1-120,121-240 --out a.png

Exit status: 0 done, 1 something is wrong with the parts or could not be
written.
)";
}

}  // namespace lentray::merge
