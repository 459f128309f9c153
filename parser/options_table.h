// The table behind parser/options.h: every option, by name and by switch, and what it does.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "parser/options.h"

namespace lentray::parser {

/// One use of an option.
struct GivenOption {
  std::string shown;           ///< as the user wrote it, for messages
  std::string where;           ///< "file.ini:12: " or empty
  std::string value;
  char sign = 0;               ///< '+' or '-' of a switch; 0: Name=Value
  bool from_defaults = false;  ///< of a default INI file
};

using ApplyOption = void (*)(RenderOptions&, const GivenOption&);

struct OptionRow {
  std::string_view name;         ///< of the INI form; empty: there is only a switch
  std::string_view switch_name;  ///< without + or -; empty: there is only a name
  ApplyOption apply = nullptr;
};

std::span<const OptionRow> option_table();

// Values, each with a message that shows the option.
[[noreturn]] void refuse(const GivenOption& given, const std::string& why);
bool truth(RenderOptions& options, const GivenOption& given);  ///< of a switch: its sign
std::int64_t whole_number(const GivenOption& given, std::int64_t least, std::int64_t most);
double number(const GivenOption& given);
/// As stock reads the numbers of its own options: what follows the number is dropped, a whole number
/// loses its fraction, and what is too small or large is cut to the range. A warning tells of all but
/// the fraction.
std::int64_t cut_whole(RenderOptions& options, const GivenOption& given, std::int64_t least, std::int64_t most);
double cut_number(RenderOptions& options, const GivenOption& given, double least, double most);
double positive(const GivenOption& given);
/// An error, or a warning when a default INI file asked for it.
void not_yet(RenderOptions& options, const GivenOption& given, const std::string& what);

}  // namespace lentray::parser
