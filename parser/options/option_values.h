// Reads the values of options, each with a message that shows the option.
// Errors: OptionError. Any number of threads, each with options of its own.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "parser/options/options.h"

namespace lentray::parser {

/// One use of an option.
struct GivenOption {
  std::string shown;  ///< as the user wrote it, for messages
  std::string where;  ///< "file.ini:12: " or empty
  std::string value;
  char sign = 0;               ///< '+' or '-' of a switch; 0: Name=Value
  bool from_defaults = false;  ///< of a default INI file
  bool from_scene = false;     ///< of an INI file that came with the scene
};

/// A part of a value, such as a number of a list.
GivenOption part_of(const GivenOption& given, std::string text);

[[noreturn]] void refuse(const GivenOption& given, const std::string& why);
/// What a word says to a switch, as stock takes it: on is what begins true, yes, on or 1, or begins with one of them,
/// letter case ignored, so nothing at all too; the rest is off.
struct SwitchWord {
  bool on = false;
  bool is_whole = false;  ///< it is one of true, yes, on, 1, false, no, off and 0
  bool is_clear = false;  ///< it is one of these or the beginning of one, but not of both kinds
};
SwitchWord switch_word(std::string_view text);
/// Of a switch its sign, else what the word says. A warning names a word that is not clear.
bool truth(RenderOptions& options, const GivenOption& given);
std::int64_t whole_number(const GivenOption& given, std::int64_t least, std::int64_t most);
/// A finite number, if the text is one.
std::optional<double> number_in(std::string_view text);
double number(const GivenOption& given);
/// As stock reads the numbers of its own options: what follows the number is dropped, a whole number
/// loses its fraction, and what is too small or large is cut to the range. A warning names all but
/// the fraction.
std::int64_t cut_whole(RenderOptions& options, const GivenOption& given, std::int64_t least,
                       std::int64_t most);
double cut_number(RenderOptions& options, const GivenOption& given, double least, double most);
double positive(const GivenOption& given);
/// The number that a text begins with, and what is behind it.
double leading_number(const GivenOption& given, std::string_view& rest);
/// A name of a list, letter case ignored. `what` is for the message: "lens model".
std::string_view choice(const GivenOption& given, const char* what,
                        std::span<const std::string_view> there);
/// The name that is nearest to what was written, if one is near at all; else empty. One or a few
/// letters may be missing, added, changed or exchanged; letter case is ignored.
std::string_view near_name(std::string_view written, std::span<const std::string_view> names);
/// An error, or a warning when a default INI file asked for it.
void not_yet(RenderOptions& options, const GivenOption& given, const std::string& what);

}  // namespace lentray::parser
