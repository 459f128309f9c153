// Receives the progress of long work. Called from any thread, must be thread-safe.
#pragma once

#include <chrono>

namespace lentray::core {

class Progress {
 public:
  /// Nothing is said at first, and then with a while between.
  static constexpr std::chrono::milliseconds kSilence{1000}, kBetween{200};

  virtual ~Progress() = default;
  /// `fraction_done`: of the work, 0..1; may fall when the rest turns out to be more.
  /// `seconds_left`: of time, as foreseen now.
  virtual void advance(double fraction_done, double seconds_left) = 0;
};

}  // namespace lentray::core
