// Progress on standard error: a bar on a terminal, a line every tenth otherwise.
#pragma once

#include <chrono>
#include <mutex>
#include <string>

#include "core/render/progress.h"

namespace lentray::tool {

class ProgressBar final : public core::Progress {
 public:
  explicit ProgressBar(std::string what);
  ~ProgressBar() override;
  void advance(double fraction_done) override;

 private:
  void draw(double fraction);
  const std::string m_what;
  const bool m_terminal;
  const std::chrono::steady_clock::time_point m_start;
  std::mutex m_mutex;
  std::chrono::steady_clock::time_point m_drawn;
  double m_done = 0.0;
  int m_tenths = 0;
};

}  // namespace lentray::tool
