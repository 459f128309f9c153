// Runs the jobs of a batch within the machine's processors and memory.
//
// Every picture begins small: one thread, with others beside it. One that takes longer than kSmall seconds, or more
// memory than its share, is stopped and gone on with when the small ones are done: alone, with all processors and the
// whole memory that a scene may take. Views and comparisons take a processor each. Rows are handed on as
// pictures are finished. Pictures run side by side as far as the disk has room for them and their journals. One that
// finds too little beside others is tried again alone; what waiting pictures have kept there gives way to it.
// Errors: none of a scene ends the run. One thread.
#pragma once

#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <vector>

#include "tools/common/child.h"
#include "tools/lentray-batch/job.h"
#include "tools/lentray-batch/progress.h"

namespace lentray::batch {

class Scheduler {
 public:
  /// `keep` gets each row once it is complete.
  Scheduler(const Plan& plan, std::function<void(const Row&)> keep, BatchProgress& progress);

  void add(std::unique_ptr<Job> job);
  /// Called about once a minute while pictures are being finished.
  void now_and_then(std::function<void()> work) { m_now_and_then = std::move(work); }
  /// False if a signal stopped it.
  bool run();

 private:
  enum class Kind { small, large, views, comparison };
  struct Running {
    Job* job;
    Kind kind;
    std::unique_ptr<tool::Child> child;
    bool is_asked = false;     ///< to stop
    bool is_set_back = false;  ///< to be gone on with later
    std::string over;          ///< why it is ended for good
    double asked_at = 0.0;     ///< seconds after its start
    bool had_company = false;  ///< others ran at the same time
  };

  int slots() const;
  void fill();
  bool start(Job& job, Kind kind);
  bool has_room_for(const Job& job) const;
  bool can_be_tried_again(Job& job, bool had_company);
  bool make_room_for(const Job& job) const;
  void next(Job& job);
  void reap();
  void ended(Running& run, const tool::Ended& how);
  void watch();
  void watch_time(Running& run);
  void watch_memory();
  void set_back(Running& run);
  void finish(Job& job);
  void stop_all();

  const Plan& m_plan;
  const std::function<void(const Row&)> m_keep;
  BatchProgress& m_progress;
  std::vector<std::unique_ptr<Job>> m_jobs;
  std::deque<Job*> m_small, m_large, m_after;  ///< m_after: views and comparisons
  std::deque<Job*> m_alone;                    ///< found too little room on the disk
  std::map<const Job*, int> m_lacked_room;     ///< how often
  std::vector<Running> m_running;
  std::function<void()> m_now_and_then;
  std::chrono::steady_clock::time_point m_watched{}, m_told;
  bool m_news = false;
};

}  // namespace lentray::batch
