// Progress over passes and the film, one after the other, each with a foreseen amount of work.
// Nothing is said in the first second, then several times a second.
// Threads: one at a time, but the film's advance(fraction, seconds_left) from any.
#pragma once

#include <chrono>

#include "core/render/progress.h"

namespace lentray::core {

class PassProgress final : public Progress {
 public:
  /// `work`: of all. `whole` (or null) hears of all.
  PassProgress(Progress* whole, double work) : m_whole(whole), m_all(work) {}

  /// What comes next takes so much of the work; what was before is done.
  void begin(double work);
  /// So much of it is done, 0..1; the time left is foreseen from the time that it took.
  void advance(double fraction_done);
  /// The same by one who foresees its own time.
  void advance(double fraction_done, double seconds_left) override;

 private:
  using Clock = std::chrono::steady_clock;
  Progress* const m_whole;
  const double m_all;
  double m_done = 0.0, m_now = 0.0;  ///< work before, and of what runs
  const Clock::time_point m_start = Clock::now();
  Clock::time_point m_begun = m_start, m_said = m_start;
};

}  // namespace lentray::core
