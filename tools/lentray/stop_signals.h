// What SIGINT, SIGTERM and SIGHUP do: they ask the run to stop, and end the program if it has not
// stopped within a second, whatever it is at; a second signal ends it at once. One object a program.
#pragma once

#include <atomic>

namespace lentray::tool {

class StopSignals {
 public:
  StopSignals();
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;

  /// True once a signal has come.
  const std::atomic<bool>& asked() const;
};

/// To standard error.
void tell_stopped();

}  // namespace lentray::tool
