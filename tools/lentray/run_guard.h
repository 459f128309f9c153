// What ends a run from outside: SIGINT, SIGTERM and SIGHUP, the time it may take and the memory it may hold. A signal
// and the time ask the run to stop, and end the program if it has not stopped within a second, whatever it is at; a
// second signal ends it at once. Memory a tenth beyond the limit ends it at once. One object a program.
#pragma once

#include <atomic>

namespace lentray::tool {

class RunGuard {
 public:
  /// Memory is watched against core::memory_limit() (core/base/memory_limit.h), whatever it is at the time.
  RunGuard();
  RunGuard(const RunGuard&) = delete;
  RunGuard& operator=(const RunGuard&) = delete;

  /// From now on, on the wall's clock.
  void limit_time(double seconds);
  /// True once the run is to stop.
  const std::atomic<bool>& asked() const;
};

/// Why there is no picture; to standard error.
void tell_stopped();

}  // namespace lentray::tool
