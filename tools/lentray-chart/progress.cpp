#include "tools/lentray-chart/progress.h"

#include <unistd.h>

#include <cstdio>

#include "tools/common/duration.h"

namespace lentray::chart {

Progress::Progress(bool quiet) : m_quiet(quiet), m_terminal(isatty(STDERR_FILENO) != 0) {}
Progress::~Progress() { clear(); }

void Progress::clear() const {
  if (!m_quiet && m_terminal) std::fputs("\r\033[K", stderr);
}

void Progress::say(const std::string& line) const {
  clear();
  std::fprintf(stderr, "%s\n", line.c_str());
}

void Progress::tell(const std::string& line) const {
  if (!m_quiet) say(line);
}

void Progress::step(const std::string& line, double done, double left) const {
  if (m_quiet) return;
  if (!m_terminal) {
    say(line);
    return;
  }
  constexpr int kWidth = 30;
  const double all = done + left;
  const int full = all > 0.0 ? static_cast<int>(kWidth * done / all) : 0;
  std::fprintf(stderr, "\r[%.*s%*s] about %s left: %.60s \033[K", full,
               "##############################", kWidth - full, "",
               tool::duration_text(left).c_str(), line.c_str());
  std::fflush(stderr);
}

}  // namespace lentray::chart
