#include "tools/lentray/progress_bar.h"

#include <unistd.h>

#include <cstdio>
#include <utility>

namespace lentray::tool {

using Clock = std::chrono::steady_clock;

ProgressBar::ProgressBar(std::string what)
    : m_what(std::move(what)), m_terminal(isatty(STDERR_FILENO) != 0), m_start(Clock::now()) {}

ProgressBar::~ProgressBar() {
  if (m_terminal && m_done > 0.0) std::fputs("\r\033[K", stderr);
}

void ProgressBar::advance(double fraction_done) {
  const std::lock_guard lock(m_mutex);
  if (fraction_done <= m_done) return;  // threads may report out of order
  m_done = fraction_done;
  if (m_terminal) {
    const auto now = Clock::now();
    if (now - m_drawn < std::chrono::milliseconds(100) && fraction_done < 1.0) return;
    m_drawn = now;
    draw(fraction_done);
    return;
  }
  const int tenths = static_cast<int>(fraction_done * 10.0);
  if (tenths <= m_tenths) return;
  m_tenths = tenths;
  std::fprintf(stderr, "%s: %d %%\n", m_what.c_str(), tenths * 10);
}

void ProgressBar::draw(double fraction) {
  constexpr int kWidth = 40;
  const int full = static_cast<int>(fraction * kWidth);
  const double spent = std::chrono::duration<double>(Clock::now() - m_start).count();
  std::fprintf(stderr, "\r%s [%.*s%*s] %3d %%  %.0f s left \033[K", m_what.c_str(), full,
               "########################################", kWidth - full, "",
               static_cast<int>(fraction * 100.0), spent / fraction - spent);
  std::fflush(stderr);
}

}  // namespace lentray::tool
