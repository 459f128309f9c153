// Warnings that say what will be wrong with a sheet. Lentray's begin with a word: "warning: jumps: the background ...".
// The table of these words is here and nowhere else; rows, page and terminal go by it.
// Pure functions; errors: none; threads: any number.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <string_view>

namespace lentray::batch {

struct WarningKind {
  std::string_view word;  ///< as Lentray writes it
  std::string_view one;   ///< what is said of one sheet
  std::string_view many;  ///< and of several
};

inline constexpr std::array<WarningKind, 4> kWarningKinds{
    {{"cut", "is cut", "are cut"},
     {"jumps", "jumps", "jump"},
     {"reversed", "is reversed", "are reversed"},
     {"flat", "is flat", "are flat"}}};

/// By word: the text behind it, a line for each warning.
using KindsFound = std::map<std::string, std::string>;

/// Adds what a line of Lentray's messages says, if it is of a kind.
void note_kind(KindsFound& found, std::string_view line);
/// Adds those of another picture that are not there yet.
void add_kinds(KindsFound& found, const KindsFound& more);
/// How many warnings these are.
std::size_t warnings_of(const KindsFound& found);
/// "2 of 10 sheets jump, 1 is flat"; empty: there is nothing to say. `sheets`: all of them.
std::string text_of(const std::map<std::string, std::size_t>& counts, std::size_t sheets);

}  // namespace lentray::batch
