// Whole numbers of values that may be anything. Errors: none. Threads: any number.
#pragma once

#include <limits>

namespace lentray::core {

/// Towards 0. What no int holds, and what is no number, is the lowest, as in the processor's own conversion.
inline int whole_of(double v) {
  constexpr double kBeyond = 2147483648.0;
  return v > -kBeyond - 1.0 && v < kBeyond ? static_cast<int>(v) : std::numeric_limits<int>::min();
}

}  // namespace lentray::core
