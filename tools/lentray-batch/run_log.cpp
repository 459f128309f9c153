#include "tools/lentray-batch/run_log.h"

#include <cstdio>

namespace lentray::batch {

std::vector<std::string> log_lines(std::istream& log, std::optional<int> view) {
  std::vector<std::string> all, ours, last;
  bool has_begun = false, is_ours = false, was_ours = false;
  for (std::string line; std::getline(log, line);) {
    int number = 0, count = 0, end = 0;
    if (view && std::sscanf(line.c_str(), "View %d of %d,%n", &number, &count, &end) == 2 &&
        end > 0) {
      has_begun = true;
      is_ours = number == *view;
      was_ours |= is_ours;
      last.clear();
      if (!is_ours) continue;
    }
    (!has_begun ? all : is_ours ? ours : last).push_back(line);
  }
  const std::vector<std::string>& own = was_ours ? ours : last;
  all.insert(all.end(), own.begin(), own.end());
  return all;
}

}  // namespace lentray::batch
