// Runs the jobs of a batch within the machine's processors and memory.
//
// Every picture begins small: its share of the processors, one where there are more pictures than these. One that takes
// longer than Plan::turn, or more memory than its share, is stopped and continued when the small ones are done:
// alone, with all processors and the whole memory that a scene may take. While others wait it is put off again and
// again, each turn twice as long as the one before, so that one that never ends holds up none. Pictures of the views of a scene (Views=) are
// made by one run; where it fails, the picture that it was at fails, and the others are tried in another run. Views of
// --views and comparisons take a processor each. Rows are handed on as pictures are finished. Pictures run side by side
// as far as the disk has room for them and their journals. One that finds too little beside others is tried again
// alone; what waiting pictures have kept there gives way to it.
// Errors: none of a scene ends the run. One thread.
#pragma once

#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <vector>

#include "tools/common/child.h"
#include "tools/lentray-batch/job.h"
#include "tools/lentray-batch/picture_run.h"
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
    PictureRun run;
    Kind kind;
    int threads;
    std::unique_ptr<tool::Child> child;
    bool is_asked = false;     ///< to stop
    bool is_set_back = false;  ///< to be continued later
    std::string over{};        ///< why it is ended for good
    double asked_at = 0.0;     ///< seconds after its start
    bool had_company = false;  ///< others ran at the same time
  };

  static bool is_of_pictures(Kind kind) { return kind == Kind::small || kind == Kind::large; }
  int slots() const;
  int free_slots() const;
  void fill();
  void start(PictureRun run, Kind kind, int threads = 1);
  bool has_room_for(const PictureRun& run) const;
  bool can_be_tried_again(PictureRun& run, bool had_company);
  bool make_room_for(const Job& job) const;
  void next(Job& job);
  void collect(Running& running);
  void reap();
  void ended(Running& running, tool::Ended how);
  void picture_ended(Running& running, const tool::Ended& how);
  void try_others(Running& running, bool was_ended);
  void watch();
  void watch_time(Running& running);
  static void watch_log(Running& running);
  void watch_memory();
  bool is_waited_for(const Running& running) const;
  void set_back(Running& running);
  void finish(Job& job);
  void stop_all();

  const Plan& m_plan;
  const std::function<void(const Row&)> m_keep;
  BatchProgress& m_progress;
  std::vector<std::unique_ptr<Job>> m_jobs;
  std::deque<PictureRun> m_small, m_large;
  std::deque<PictureRun> m_alone;           ///< found too little room on the disk
  std::deque<Job*> m_after;                 ///< for their views, or comparison
  std::map<const Job*, int> m_lacked_room;  ///< how often
  std::vector<Running> m_running;
  std::function<void()> m_now_and_then;
  std::chrono::steady_clock::time_point m_watched{}, m_told;
  bool m_news = false;
};

}  // namespace lentray::batch
