// What is reported of a pass at the end (core/pass/pass_list.h).
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace lentray::core {

/// Numbers of the statistics by name, in the order in which the pass counts them.
using PassNumbers = std::vector<std::pair<std::string, double>>;

/// Seconds: on the clock, and of all threads.
struct PassReport {
  std::string name{};
  double wall_s = 0.0, cpu_s = 0.0;
  PassNumbers numbers{};
};

}  // namespace lentray::core
