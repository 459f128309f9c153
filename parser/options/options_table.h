// The table behind parser/options/options.h: every option, by name and by switch, and what it does.
#pragma once

#include <span>
#include <string_view>

#include "parser/options/option_values.h"
#include "parser/options/options.h"

namespace lentray::parser {

using ApplyOption = void (*)(RenderOptions&, const GivenOption&);

struct OptionRow {
  std::string_view name;         ///< of the INI form; empty: there is only a switch
  std::string_view switch_name;  ///< without + or -; empty: there is only a name
  ApplyOption apply = nullptr;
};

std::span<const OptionRow> option_table();

/// The word that an option of a file's type, or of a way of dithering, is given by.
std::string_view word_of(core::FileType type);
std::string_view word_of(core::DitherMethod method);

}  // namespace lentray::parser
