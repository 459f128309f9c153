#include "tools/lentray-batch/progress.h"

#include <unistd.h>

#include <cstdio>

#include "parser/base/shown.h"
#include "tools/common/duration.h"

namespace lentray::batch {

using Clock = std::chrono::steady_clock;

BatchProgress::BatchProgress(std::size_t total, std::size_t kept, std::size_t kept_failed,
                             bool quiet)
    : m_total(total), m_kept(kept), m_quiet(quiet), m_terminal(isatty(STDERR_FILENO) != 0),
      m_start(Clock::now()) {
  if (!m_quiet && kept > 0)
    say(std::to_string(kept - kept_failed) + " of " + std::to_string(total) +
        " pictures are there and up to date" +
        (kept_failed > 0
             ? "; " + std::to_string(kept_failed) +
                   " failed before, and nothing of them has changed (--retry tries them)"
             : ""));
}

BatchProgress::~BatchProgress() { clear(); }

void BatchProgress::clear() const {
  if (!m_quiet && m_terminal) std::fputs("\r\033[K", stderr);
}

void BatchProgress::say(const std::string& line) {
  clear();
  std::fprintf(stderr, "%s\n", parser::shown_name(line).c_str());
}

void BatchProgress::finished(const Row& row) {
  ++m_done;
  if (row.state == State::failed) ++m_failed;
  if (m_quiet) return;
  const bool is_short = row.state == State::failed || !m_terminal;
  if (is_short) {
    std::string line = "[" + std::to_string(m_kept + m_done) + "/" + std::to_string(m_total) +
                       "] " + row.name + ": ";
    if (row.state == State::failed) {
      line += "failed: " + row.reason;
    } else {
      line += tool::duration_text(row.wall);
      for (const auto& kind : row.kinds) line += ", " + kind.first;
      if (row.warnings > 0)
        line +=
            ", " + std::to_string(row.warnings) + (row.warnings == 1 ? " warning" : " warnings");
      if (row.verdict)
        line += ", " + (row.verdict->grade.empty() ? "not compared: " + row.verdict->note
                                                   : row.verdict->grade);
    }
    say(line);
  }
  draw(m_running);
}

double BatchProgress::seconds_left() const {
  const double taken = std::chrono::duration<double>(Clock::now() - m_start).count();
  return m_done == 0
             ? -1.0
             : taken / static_cast<double>(m_done) * static_cast<double>(m_total - m_kept - m_done);
}

void BatchProgress::running(std::size_t count) {
  constexpr std::chrono::milliseconds kOften{200};
  if (m_quiet || !m_terminal || (count == m_running && Clock::now() - m_drawn < kOften)) return;
  draw(count);
}

void BatchProgress::draw(std::size_t running) {
  m_running = running;
  if (m_quiet || !m_terminal) return;
  m_drawn = Clock::now();
  constexpr int kWidth = 30;
  const std::size_t there = m_kept + m_done;
  const int full = m_total == 0 ? kWidth : static_cast<int>(kWidth * there / m_total);
  const double left = seconds_left();
  std::fprintf(stderr, "\r[%.*s%*s] %zu of %zu done, %zu running, %zu failed%s%s \033[K", full,
               "##############################", kWidth - full, "", there - m_failed, m_total,
               running, m_failed, left < 0.0 ? "" : ", ",
               left < 0.0 ? "" : (tool::duration_text(left) + " left").c_str());
  std::fflush(stderr);
}

}  // namespace lentray::batch
