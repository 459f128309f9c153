// How far a batch is, on standard error: a bar on a terminal, a line a scene elsewhere. One thread.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>

#include "tools/lentray-batch/row.h"

namespace lentray::batch {

class BatchProgress {
 public:
  /// `total` pictures, of which `kept` are there already.
  BatchProgress(std::size_t total, std::size_t kept, std::size_t kept_failed, bool quiet);
  ~BatchProgress();

  void finished(const Row& row);
  /// To be called now and then.
  void running(std::size_t count);
  /// A line of its own.
  void say(const std::string& line);

 private:
  void draw(std::size_t running);
  void clear() const;
  double seconds_left() const;

  const std::size_t m_total, m_kept;
  const bool m_quiet, m_terminal;
  std::size_t m_done = 0, m_failed = 0, m_running = 0;
  const std::chrono::steady_clock::time_point m_start;
  std::chrono::steady_clock::time_point m_drawn{};
};

}  // namespace lentray::batch
