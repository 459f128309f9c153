// Jobs that are made on many threads and committed one by one, in the order of their numbers. Who
// brings the result that is next commits it and those behind it that are there; who is too far
// ahead waits. Threads: any number.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

namespace lentray::core {

template <class Result>
class PassQueue {
 public:
  /// Jobs from `first` up to `jobs`.
  PassQueue(std::size_t first, std::size_t jobs, unsigned threads)
      : m_jobs(jobs), m_slots(kAhead * std::size_t{threads}), m_next(first), m_committed(first) {}

  /// False when there are no more jobs, or after stop(). May wait for commits.
  bool take(std::size_t& job) {
    std::unique_lock lock(m_mutex);
    m_changed.wait(lock, [this] {
      return m_stopped || m_next >= m_jobs || m_next < m_committed + m_slots.size();
    });
    if (m_stopped || m_next >= m_jobs) return false;
    job = m_next++;
    return true;
  }

  /// `commit(job, result)` is called without the lock, and says whether to go on.
  template <class Commit>
  void give(std::size_t job, Result result, Commit& commit) {
    std::unique_lock lock(m_mutex);
    slot(job) = std::move(result);
    if (m_committing) return;
    m_committing = true;
    while (!m_stopped && m_committed < m_jobs && slot(m_committed)) {
      Result next = std::move(*slot(m_committed));
      slot(m_committed).reset();
      lock.unlock();
      const bool goes_on = commit(m_committed, std::move(next));
      lock.lock();
      ++m_committed;
      if (!goes_on) m_stopped = true;
      m_changed.notify_all();
    }
    m_committing = false;
  }

  /// No more jobs, no more commits.
  void stop() {
    const std::lock_guard lock(m_mutex);
    m_stopped = true;
    m_changed.notify_all();
  }

  /// The job behind the last one that was committed. When no thread is at it any more.
  std::size_t committed() const { return m_committed; }

 private:
  static constexpr std::size_t kAhead = 8;  ///< results a thread that wait for their turn
  std::optional<Result>& slot(std::size_t job) { return m_slots[job % m_slots.size()]; }

  const std::size_t m_jobs;
  std::mutex m_mutex;
  std::condition_variable m_changed;
  std::vector<std::optional<Result>> m_slots;
  std::size_t m_next, m_committed;  ///< m_committed: only who commits changes it
  bool m_committing = false, m_stopped = false;
};

}  // namespace lentray::core
