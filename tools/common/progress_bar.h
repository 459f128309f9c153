// Progress on standard error: a bar on a terminal, a line every twentieth otherwise. Both show the
// time left.
#pragma once

#include <mutex>
#include <string>

#include "core/render/progress.h"

namespace lentray::tool {

class ProgressBar final : public core::Progress {
 public:
  explicit ProgressBar(std::string what);
  ~ProgressBar() override;
  void advance(double fraction_done, double seconds_left) override;

 private:
  void draw(double seconds_left) const;
  const std::string m_what;
  const bool m_terminal;
  std::mutex m_mutex;
  double m_done = 0.0;  ///< the most there was: a bar does not go back
  int m_steps = 0;      ///< that lines were printed for
};

}  // namespace lentray::tool
