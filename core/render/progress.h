// Receives the progress of long work. Called from any thread, must be thread-safe.
#pragma once

namespace lentray::core {

class Progress {
 public:
  virtual ~Progress() = default;
  virtual void advance(double fraction_done) = 0;  ///< 0..1, monotonic enough for a bar
};

}  // namespace lentray::core
