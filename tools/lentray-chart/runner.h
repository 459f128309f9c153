// Programs that a chart runs, one at a time: their processor time alone, what they said, and an end to them when a
// signal asks the chart to stop. hold_signals() (tools/common/child.h) was called before.
// Errors: std::runtime_error if no program can be started. One thread.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace lentray::chart {

/// Thrown when a signal asks to stop; the program that ran has ended.
struct Stopped {};

struct Outcome {
  int status = 0;
  double cpu_s = 0.0;  ///< of the program with all that it ran
  std::string output{};
  bool over_limit = false;  ///< it was ended because of its processor time
};

class Runner {
 public:
  /// `log`: a file for what programs say.
  explicit Runner(std::filesystem::path log) : m_log(std::move(log)) {}
  /// cpu_limit: s, 0: none.
  Outcome run(const std::vector<std::string>& command, double cpu_limit = 0.0) const;

 private:
  std::filesystem::path m_log;
};

/// Why a program did not do its work, in a line.
std::string reason_of(const Outcome& outcome, const std::string& program);

}  // namespace lentray::chart
