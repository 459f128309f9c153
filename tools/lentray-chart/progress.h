// How far a chart is, on standard error: a bar with the time left on a terminal, a line a step elsewhere. One thread.
#pragma once

#include <string>

namespace lentray::chart {

class Progress {
 public:
  explicit Progress(bool quiet);
  ~Progress();
  /// A line of its own that is always said.
  void say(const std::string& line) const;
  /// A line of its own, unless it is quiet.
  void tell(const std::string& line) const;
  /// A step that is over, and how it goes on; s of processor time. `line` is for where there is no terminal.
  void step(const std::string& line, double done, double left) const;

 private:
  void clear() const;
  const bool m_quiet, m_terminal;
};

}  // namespace lentray::chart
