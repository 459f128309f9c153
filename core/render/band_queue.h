// The bands of a frame: gives out the jobs of their stages, top band first, and passes finished
// bands on in that order. A few bands are in memory at a time, so that threads continue with the next band while
// one of them writes the last. Who finishes a band writes it; who finds no memory free waits.
// Errors: what the sink throws reaches whoever finished the band; others then get no more jobs.
// Threads: any number.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "core/image/image.h"
#include "core/render/band_sink.h"
#include "core/render/film.h"

namespace lentray::core {

/// An image, and how many of its rows a band has (the last one may have fewer).
struct FrameShape {
  std::uint32_t width = 0, height = 0;
  std::uint32_t band_height = 0;  ///< at least 1 unless the image is empty
  bool is_whole = true;           ///< false: there are pixels that the film leaves black
};

struct Band {
  std::uint32_t top = 0;
  Image image{};                              ///< row 0 is the image's row `top`
  std::unique_ptr<FilmBand> film{};           ///< null: nothing to do
  std::size_t stages = 0, stage = 0;          ///< all, and how many are done
  std::size_t jobs = 0, taken = 0, done = 0;  ///< of the present stage
  bool is_done() const { return stage == stages; }
};

class BandQueue {
 public:
  static constexpr std::size_t kInMemory = 2;  ///< bands: one is written, one rendered

  struct Job {
    Band* band = nullptr;
    std::size_t stage = 0, index = 0;
  };

  BandQueue(const FrameShape& shape, const Film& film, BandSink& sink);
  /// False when there are no more jobs, or after stop(). May wait for memory.
  bool next(Job& job);
  /// The job is done. May write bands.
  void finish(const Job& job);
  /// No more jobs, no more bands to the sink.
  void stop();

 private:
  bool take(Job& job);
  /// Every stage that will be is the last of its band, and its jobs are taken.
  bool all_given();
  void open_next();
  void begin_stage(Band& band);
  /// Writes what is done, unless another thread is at it.
  void write_done(std::unique_lock<std::mutex>& lock);
  Band& slot(std::size_t band) { return m_slots[band % kInMemory]; }

  const FrameShape m_shape;
  const Film& m_film;
  BandSink& m_sink;
  const std::size_t m_bands;
  std::mutex m_mutex;
  std::condition_variable m_changed;
  std::vector<Band> m_slots;
  std::size_t m_opened = 0, m_written = 0;  ///< bands
  bool m_writing = false, m_stopped = false;
};

}  // namespace lentray::core
