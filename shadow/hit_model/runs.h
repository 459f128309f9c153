// Runs of blocked shadow rays in a sequence, without listing it: sequences are put together from
// parts, and each knows how many blocked rays it begins and ends with and its longest run.
// Counts of rays. Values; any number of threads.
#pragma once

#include <algorithm>
#include <cstdint>

namespace lentray::shadow {

struct Runs {
  std::uint64_t length = 0;  ///< rays in all
  std::uint64_t first = 0;   ///< blocked ones it begins with
  std::uint64_t last = 0;    ///< blocked ones it ends with
  std::uint64_t longest = 0;

  static Runs blocked(std::uint64_t n) { return {n, n, n, n}; }
  static Runs open(std::uint64_t n) { return {n, 0, 0, 0}; }
  bool all_blocked() const { return first == length; }

  /// This sequence, then the other.
  Runs& operator+=(const Runs& next) {
    longest = std::max({longest, next.longest, last + next.first});
    first = all_blocked() ? length + next.first : first;
    last = next.all_blocked() ? last + next.length : next.last;
    length += next.length;
    return *this;
  }
};

}  // namespace lentray::shadow
