// What --help shows of the options of parser/options/options_table.h, and the --help=all that manual pages
// and shell completions are made of (tools/manual.py). A test holds that every option has its lines.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace lentray::parser {

/// One option's lines.
struct OptionHelp {
  std::string_view name;   ///< as in the table; with -- in front: not of the table
  std::string_view value;  ///< what stands behind =: n, file, or words with | between them
  std::string_view text = {};
  std::string_view switches = {};  ///< empty: made of the table's switch and of `value`
};

struct OptionGroup {
  std::string_view title;
  std::span<const OptionHelp> rows;
};

std::span<const OptionGroup> option_groups();

/// "Width=n, +Wn".
std::string option_forms(const OptionHelp& row);

/// What is used every day, on one screen.
std::string help_text();

/// All options, the files, the environment, examples.
std::string full_help_text();

}  // namespace lentray::parser
