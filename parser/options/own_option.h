// Options that a program has beside lentray's: `--name value` or `--name=value`, and the older
// spelling `Name=value`. A name of two words is Strip_Width in tables and --strip-width on command
// lines. Errors: OptionError. Pure.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "parser/options/option_values.h"

namespace lentray::parser {

struct OwnOption {
  std::size_t index;  ///< in the names
  GivenOption given;
};

/// The option at words[at], if it has one of the names. `at` moves on to its value if that is a word
/// of its own.
std::optional<OwnOption> own_option(const std::vector<std::string>& words, std::size_t& at,
                                    std::span<const std::string_view> names);

/// Strip_Width as --strip-width.
std::string long_name(std::string_view name);

}  // namespace lentray::parser
