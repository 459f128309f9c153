// Options that a program has beside lentray's: `--name value` or `--name=value`, and the older
// spelling `Name=value`. A name of two words is Strip_Width in tables and --strip-width on command
// lines. Errors: OptionError. Pure.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "parser/options/option_values.h"

namespace lentray::parser {

/// What is given of the option of that name, if it stands at words[at]. `at` moves on to its value if that is a word
/// of its own.
std::optional<GivenOption> own_option(const std::vector<std::string>& words, std::size_t& at,
                                      std::string_view name);

/// A row of a program's table of options.
template <class Target>
struct OwnOption {
  std::string_view name;
  void (*apply)(Target& target, const GivenOption& given);
};

/// Does what the row says whose option stands at words[at]; false: there is none.
template <class Target, std::size_t N>
bool take_own_option(const std::vector<std::string>& words, std::size_t& at,
                     const OwnOption<Target> (&rows)[N], Target& target) {
  for (const OwnOption<Target>& row : rows) {
    const auto given = own_option(words, at, row.name);
    if (!given) continue;
    row.apply(target, *given);
    return true;
  }
  return false;
}

/// What a row does that only sets a member, given as `Place`: what `read` makes of the value within the limits.
template <auto Place, auto read, auto... Limits>
inline constexpr auto set = [](auto& target, const GivenOption& given) {
  auto& place = std::invoke(Place, target);
  place = static_cast<std::remove_reference_t<decltype(place)>>(read(given, Limits...));
};
/// A place for it: a member of a member.
template <auto Outer, auto Inner>
inline constexpr auto of_member = [](auto& target) -> auto& {
  return target.*Outer.*Inner;
};

/// "the name of a file is expected", unless it is there.
std::filesystem::path file_name(const GivenOption& given, const char* what = "file");

inline std::filesystem::path any_file(const GivenOption& given) { return file_name(given); }
/// The second of two words, and not the first.
bool is_second(const GivenOption& given, const std::string& first, const std::string& second);

/// Strip_Width as --strip-width.
std::string long_name(std::string_view name);

}  // namespace lentray::parser
