// How far a frame is. What is left of a stage is expected to cost what its pixels have cost so far, and
// the time left follows the time that the work done took. Pixels of the image.
#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>

#include "core/render/picture_ledger.h"
#include "core/render/progress.h"

namespace lentray::core {

struct FilmSetup;

/// Any number of threads.
class FrameProgress {
 public:
  using Clock = std::chrono::steady_clock;

  /// The listener outlives it. `start`: when the frame begins.
  FrameProgress(Progress& listener, const FilmSetup& film, Clock::time_point start = Clock::now());
  /// A thread spent a time on pixels of a stage, until now. Tells the listener when it is time to.
  void add(std::size_t stage, std::uint64_t pixels, Clock::duration spent, Clock::time_point now);

 private:
  struct Stage {
    double all = 0.0;    ///< pixels that will be visited
    double guess = 0.0;  ///< what a pixel costs, by one of stage 0, as long as none is visited
    std::atomic<std::uint64_t> visited{0};
    std::atomic<Clock::rep> spent{0};
  };
  void tell(Clock::time_point now);

  Progress& m_listener;
  const Clock::time_point m_start;
  std::atomic<Clock::rep> m_next;  ///< when the listener hears more, from the start
  std::array<Stage, PictureLedger::kStages> m_stages{};
};

/// Reports the work of one thread, of several pixels at a time.
class FrameMeter {
 public:
  explicit FrameMeter(FrameProgress& progress) : m_progress(progress) {}
  /// A job of the stage begins, or ends.
  void begin(std::size_t stage) {
    m_stage = stage;
    m_read = FrameProgress::Clock::now();
  }
  void end() { report(); }
  void pixel() {
    if (++m_pixels == kTogether) report();
  }

 private:
  static constexpr std::uint64_t kTogether = 16;
  void report() {
    const FrameProgress::Clock::time_point now = FrameProgress::Clock::now();
    m_progress.add(m_stage, m_pixels, now - m_read, now);
    m_read = now;
    m_pixels = 0;
  }

  FrameProgress& m_progress;
  std::size_t m_stage = 0;
  std::uint64_t m_pixels = 0;
  FrameProgress::Clock::time_point m_read{};
};

}  // namespace lentray::core
