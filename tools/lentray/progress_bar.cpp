#include "tools/lentray/progress_bar.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

namespace lentray::tool {
namespace {

constexpr int kSteps = 20;  ///< lines for a whole picture

/// As exact as it helps: 7.4 s, 52 s, 12 min 30 s, 3 h 5 min.
std::string time_text(double seconds) {
  char text[64];
  if (seconds < 9.95) {
    std::snprintf(text, sizeof text, "%.1f s", std::max(0.0, seconds));
  } else if (seconds < 99.5) {
    std::snprintf(text, sizeof text, "%.0f s", seconds);
  } else if (seconds < 3570.0) {
    const long long tens = std::llround(seconds / 10.0);
    std::snprintf(text, sizeof text, "%lld min %lld s", tens / 6, tens % 6 * 10);
  } else {
    const long long minutes = std::llround(seconds / 60.0);
    std::snprintf(text, sizeof text, "%lld h %lld min", minutes / 60, minutes % 60);
  }
  return text;
}

}  // namespace

ProgressBar::ProgressBar(std::string what) : m_what(std::move(what)), m_terminal(isatty(STDERR_FILENO) != 0) {}

ProgressBar::~ProgressBar() {
  if (m_terminal && m_done > 0.0) std::fputs("\r\033[K", stderr);
}

void ProgressBar::advance(double fraction_done, double seconds_left) {
  const std::lock_guard lock(m_mutex);
  m_done = std::max(m_done, fraction_done);
  if (m_terminal) {
    draw(seconds_left);
    return;
  }
  const int steps = static_cast<int>(m_done * kSteps);
  if (steps <= m_steps) return;
  m_steps = steps;
  const int percent = steps * 100 / kSteps;
  if (steps == kSteps) {
    std::fprintf(stderr, "%s: %d %%\n", m_what.c_str(), percent);
  } else {
    std::fprintf(stderr, "%s: %d %%, %s left\n", m_what.c_str(), percent, time_text(seconds_left).c_str());
  }
}

void ProgressBar::draw(double seconds_left) const {
  constexpr int kWidth = 40;
  const int full = static_cast<int>(m_done * kWidth);
  std::fprintf(stderr, "\r%s [%.*s%*s] %3d %%  %s left \033[K", m_what.c_str(), full,
               "########################################", kWidth - full, "",
               static_cast<int>(m_done * 100.0), time_text(seconds_left).c_str());
  std::fflush(stderr);
}

}  // namespace lentray::tool
