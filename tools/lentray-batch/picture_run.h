// One run of lentray: a picture, or views of a scene one after another, which is then read once.
//
// The scheduler asks it for the picture that is being made, hands on those that are done, and gives what is left to
// another run where this one ends early. A run without pictures is over.
// Errors: as tools/lentray-batch/job.h. One thread.
#pragma once

#include <deque>

#include "tools/common/child.h"
#include "tools/lentray-batch/job.h"

namespace lentray::batch {

class PictureRun {
 public:
  /// `turn`: see turn().
  PictureRun(Job& job, double turn) : m_jobs{&job}, m_turn(turn) {}
  /// False where that picture cannot be made after the last one of this run.
  bool take(Job& job);

  Job& job() const { return *m_jobs.front(); }  ///< the one being made
  const std::deque<Job*>& jobs() const { return m_jobs; }
  /// The bytes on the disk that it may need, at most about.
  double room() const;

  tool::Launch launch(int threads, double memory);
  /// The next picture that is done while the run goes on; null: none.
  Job* made();
  /// The run's end, without what the pictures took that were made before.
  tool::Ended rest(tool::Ended ended) const;
  /// It ended without the picture. The others are left.
  void drop_first() { m_jobs.pop_front(); }
  /// Seconds of this run, `seconds` after its start, that the picture being made has had.
  double seconds_of_picture(double seconds) const { return seconds - m_told.wall; }
  /// Seconds that a picture gets of a run while others wait.
  double turn() const { return m_turn; }
  void lengthen_turn() { m_turn *= 2.0; }
  /// Stopping it pays if others are idle: what is left will take longer than reading the scene again.
  bool is_worth_stopping() const;
  /// Its failure for this reason would be that of all its pictures: the scene was not read before it was ended, or
  /// two runs in a row failed at once in the same way.
  bool is_of_scene(bool was_ended, const std::string& reason);

 private:
  std::deque<Job*> m_jobs;
  double m_turn;
  int m_threads = 1;
  // Of the pictures that are made, in this run and ever.
  tool::Ended m_told;
  double m_reading = 0.0;  ///< seconds that the scene took
  int m_made = 0;
  bool m_can_be_made = false;
  std::string m_failed_with;  ///< at once
};

}  // namespace lentray::batch
