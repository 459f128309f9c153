#include "tools/common/progress_bar.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <utility>

#include "tools/common/duration.h"

namespace lentray::tool {
namespace {

constexpr int kSteps = 20;  ///< lines for a whole picture

}  // namespace

ProgressBar::ProgressBar(std::string what)
    : m_what(std::move(what)), m_terminal(isatty(STDERR_FILENO) != 0) {}

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
    std::fprintf(stderr, "%s: %d%%\n", m_what.c_str(), percent);
  } else {
    std::fprintf(stderr, "%s: %d%%, %s left\n", m_what.c_str(), percent,
                 duration_text(seconds_left).c_str());
  }
}

void ProgressBar::draw(double seconds_left) const {
  constexpr int kWidth = 40;
  const int full = static_cast<int>(m_done * kWidth);
  std::fprintf(stderr, "\r%s [%.*s%*s] %3d%%  %s left \033[K", m_what.c_str(), full,
               "########################################", kWidth - full, "",
               static_cast<int>(m_done * 100.0), duration_text(seconds_left).c_str());
  std::fflush(stderr);
}

}  // namespace lentray::tool
