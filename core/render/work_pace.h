// How much of its work a frame does in a second of time: CPU seconds, of all threads, of late.
#pragma once

#include <algorithm>
#include <cmath>

namespace lentray::core {

class WorkPace {
 public:
  /// `time` since the frame began, `done` of its work by then, both in seconds and ascending.
  void add(double time, double done) {
    const double step = time - m_time;
    if (step <= 0.0) return;
    // What lies further back than a third of the way counts little.
    const double kept = std::exp(-step / std::max(kLeast, time / 3.0));
    m_spent = m_spent * kept + step;
    m_worked = m_worked * kept + (done - m_done);
    m_time = time;
    m_done = done;
  }
  /// Time that work takes.
  double seconds(double work) const { return m_worked > 0.0 ? work * m_spent / m_worked : 0.0; }

 private:
  static constexpr double kLeast = 2.0;  ///< seconds that are looked back over
  double m_time = 0.0, m_done = 0.0;
  double m_spent = 0.0, m_worked = 0.0;
};

}  // namespace lentray::core
