// Threads with deep stacks that stay through a list of passes: one of them, the leader, runs the
// passes, and the others do what it shares with them. A share may be as short as some rays: who
// waits for the next one does so without a lock.
// Errors: the first failure of a share reaches the leader when all have ended theirs.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <mutex>

namespace lentray::core {

class PassTeam {
 public:
  /// Runs `lead` on one of `threads` threads, whose stacks have room for `levels`
  /// (run_on_threads()). What it throws reaches the caller.
  static void run(unsigned threads, std::size_t levels, const std::function<void(PassTeam&)>& lead);

  unsigned count() const { return m_count; }
  /// Calls share(thread) on the leader, which is thread 0, and on the others as they come: one that
  /// is late may miss it. So a share takes jobs until there are none. Only the leader calls.
  void all(const std::function<void(unsigned)>& share);

 private:
  using Share = std::function<void(unsigned)>;
  /// A word of state: the number of the present share, whether it is open, and how many others are
  /// at it.
  static constexpr std::uint32_t kOne = 1u << 16, kOpen = 1u << 15, kInside = kOpen - 1;
  static constexpr std::uint32_t kEnd = kInside;  ///< not open, and more inside than there can be

  explicit PassTeam(unsigned count) : m_count(count) {}
  void serve(unsigned thread);
  void do_share(unsigned thread);

  const unsigned m_count;
  std::atomic<unsigned> m_arrived{0};
  std::atomic<std::uint32_t> m_state{0};
  const Share* m_share = nullptr;  ///< while it is open
  std::mutex m_mutex;
  std::exception_ptr m_failure;  ///< of a share
};

}  // namespace lentray::core
