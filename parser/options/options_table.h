// The table behind parser/options/options.h: every option, by name and by switch, what it does, and the
// line of an INI file that asks for it again.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

#include "parser/options/ini_lines.h"
#include "parser/options/option_values.h"
#include "parser/options/options.h"

namespace lentray::parser {

using ApplyOption = void (*)(RenderOptions&, const GivenOption&);
using WriteOption = void (*)(const RenderOptions&, std::string_view name, IniLines&);

struct OptionAccess {
  ApplyOption apply = nullptr;
  WriteOption write = nullptr;  ///< null: no line

  constexpr OptionAccess(ApplyOption apply_, WriteOption write_ = nullptr)
      : apply(apply_), write(write_) {}
};

/// What an option decides. An INI file that came with a scene says all but kRun.
enum class OptionUse : std::uint8_t {
  kRun,      ///< what is read, written and run, messages and limits: the user's to say
  kWay,      ///< frames, where the scene's files are looked for, the way to the same colours
  kNothing,  ///< how stock works inside: no such things here, and no effect on the picture
  kFile,     ///< how the picture's file holds it
  kPicture,  ///< the colours of pixels
  kLight     ///< what light there is, wherever it is seen from
};

struct OptionRow {
  std::string_view name;         ///< of the INI form; empty: there is only a switch
  std::string_view switch_name;  ///< without + or -; empty: there is only a name
  OptionAccess access;
  OptionUse use = OptionUse::kRun;
};

std::span<const OptionRow> option_table();

}  // namespace lentray::parser
