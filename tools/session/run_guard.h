// What ends a run from outside: SIGINT, SIGTERM and SIGHUP, the time it may take and the memory it
// may hold; all that is the process's and not a session's. A signal and the time ask the run to
// stop (asked(), which readings and renderings look at), and end the program if it has not stopped
// within a second, whatever it is at; a second signal ends it at once. Memory a tenth beyond the
// limit ends it at once. One object a program, for as long as it may be ended.
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <thread>

namespace lentray::tool {

class RunGuard {
 public:
  /// `keep`: called before the program is ended, on any thread; null: nothing is to be kept.
  explicit RunGuard(std::function<void()> keep = {});
  ~RunGuard();

  /// From now on, on the wall's clock.
  void limit_time(double seconds);
  /// Bytes of the process (core/base/memory_limit.h).
  void limit_memory(double bytes);
  /// True once the run is to stop.
  const std::atomic<bool>& asked() const;
  /// Why there is no picture; to standard error.
  void tell_stopped() const;

 private:
  using Clock = std::chrono::steady_clock;
  void watch(const std::stop_token& stop);
  void end_if_too_large() const;
  [[noreturn]] void end(int status) const;

  const std::function<void()> m_keep;
  std::atomic<Clock::time_point> m_deadline{Clock::time_point::max()};
  std::atomic<bool> m_time_is_over{false};
  std::jthread m_watch;  // last: it uses the others
};

}  // namespace lentray::tool
