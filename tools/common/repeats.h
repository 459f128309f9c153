// Figures of runs that were repeated. Pure.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace lentray::tool {

/// 0 of none.
inline double median_of(std::vector<double> values) {
  if (values.empty()) return 0.0;
  std::ranges::sort(values);
  const std::size_t n = values.size();
  return n % 2 == 1 ? values[n / 2] : 0.5 * (values[n / 2 - 1] + values[n / 2]);
}

}  // namespace lentray::tool
