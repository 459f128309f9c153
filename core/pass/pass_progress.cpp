#include "core/pass/pass_progress.h"

#include <algorithm>

namespace lentray::core {
namespace {

double seconds(std::chrono::steady_clock::duration time) {
  return std::chrono::duration<double>(time).count();
}

}  // namespace

void PassProgress::begin(double work) {
  m_done += m_now;
  m_now = work;
  m_begun = Clock::now();
}

void PassProgress::advance(double fraction_done) {
  if (!m_whole || !(fraction_done > 0.0)) return;
  const Clock::time_point now = Clock::now();
  if (now < m_start + kSilence || now < m_said + kBetween) return;
  m_said = now;
  advance(fraction_done, seconds(now - m_begun) * (1.0 - fraction_done) / fraction_done);
}

void PassProgress::advance(double fraction_done, double seconds_left) {
  if (!m_whole) return;
  const double done = m_done + m_now * fraction_done;
  const double later = std::max(0.0, m_all - m_done - m_now);
  const double pace = done > 0.0 ? seconds(Clock::now() - m_start) / done : 0.0;
  m_whole->advance(m_all > 0.0 ? std::min(1.0, done / m_all) : 0.0, seconds_left + later * pace);
}

}  // namespace lentray::core
