// What a running pass has at hand: threads, commits in order, progress, statistics, and the records
// by which a pass that was cut off is continued. Jobs are short, for between two of them the run
// is cancelled (PassCancelled, which passes let through).
// Threads: one calls; each() and in_order() call back from many.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstring>
#include <functional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/base/damaged_record.h"
#include "core/pass/pass_ledger.h"
#include "core/pass/pass_progress.h"
#include "core/pass/pass_queue.h"
#include "core/pass/pass_report.h"
#include "core/pass/pass_team.h"

namespace lentray::core {

/// Ends a pass that is cancelled; caught by PassList::run().
struct PassCancelled {};

class PassRun {
 public:
  /// `cancel`, `ledger` may be null.
  PassRun(PassTeam& team, PassProgress& progress, const std::atomic<bool>* cancel,
          PassLedger* ledger)
      : m_team(team), m_progress(progress), m_cancel(cancel), m_ledger(ledger) {}

  /// Threads have numbers below it.
  unsigned threads() const { return m_team.count(); }
  bool is_cancelled() const { return m_cancel && m_cancel->load(std::memory_order_relaxed); }
  void check_cancelled() const {
    if (is_cancelled()) throw PassCancelled();
  }
  /// So much of the pass is done, 0..1.
  void advance(double fraction) { m_progress.advance(fraction); }
  void count(std::string name, double value) { m_numbers.emplace_back(std::move(name), value); }
  const PassNumbers& numbers() const { return m_numbers; }

  /// The next record of an earlier run of this pass; false: there are no more.
  bool recall(std::string& record) { return m_ledger && m_ledger->recall(record); }
  /// Keeps a record of what is committed. Only when all have been recalled.
  void keep(std::string_view record) {
    if (m_ledger) m_ledger->keep(record);
  }

  /// `work(thread, job)` for every job below `jobs`, on any thread, in any order.
  template <class Work>
  void each(std::size_t jobs, Work&& work) {
    std::atomic<std::size_t> next{0};
    m_team.all([&](unsigned thread) {
      for (std::size_t job; !is_cancelled() && (job = next.fetch_add(1)) < jobs;) work(thread, job);
    });
    check_cancelled();
  }

  /// `make(thread, job)` on any thread gives a job's result; `commit(job, result)` gets the results
  /// in the order of their jobs, one at a time, and says whether to go on. What was made ahead of a
  /// commit that says no is dropped. Jobs begin with `first`. Returns how far it got.
  template <class Make, class Commit>
  std::size_t in_order(std::size_t first, std::size_t jobs, Make&& make, Commit&& commit) {
    using Result = std::decay_t<std::invoke_result_t<Make&, unsigned, std::size_t>>;
    PassQueue<Result> queue(first, jobs, m_team.count());
    m_team.all([&](unsigned thread) {
      try {
        for (std::size_t job; !is_cancelled() && queue.take(job);)
          queue.give(job, make(thread, job), commit);
      } catch (...) {
        queue.stop();
        throw;
      }
      if (is_cancelled()) queue.stop();
    });
    check_cancelled();
    return queue.committed();
  }

  /// The same with results that are kept: a job that an earlier run committed is not made again. Throws DamagedRecord.
  template <class T, class Make, class Commit>
  std::size_t in_order_kept(std::size_t jobs, Make&& make, Commit&& commit) {
    static_assert(std::is_trivially_copyable_v<T>);
    std::size_t job = 0;
    for (std::string record; job < jobs && recall(record); ++job) {
      if (record.size() % sizeof(T) != 0) throw DamagedRecord();
      std::vector<T> result(record.size() / sizeof(T));
      if (!result.empty()) std::memcpy(result.data(), record.data(), result.size() * sizeof(T));
      if (!commit(job, std::move(result))) return job + 1;
    }
    return in_order(job, jobs, make, [&](std::size_t at, std::vector<T> result) {
      keep({reinterpret_cast<const char*>(result.data()), result.size() * sizeof(T)});
      return commit(at, std::move(result));
    });
  }

 private:
  PassTeam& m_team;
  PassProgress& m_progress;
  const std::atomic<bool>* const m_cancel;
  PassLedger* const m_ledger;
  PassNumbers m_numbers;
};

}  // namespace lentray::core
