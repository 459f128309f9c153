// The bands of a frame: gives out their jobs, top band first, and passes finished bands on in
// that order. A few bands are in memory at a time, so that threads go on with the next band while
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
#include "core/render/pixel_order.h"

namespace lentray::core {

/// An image, and how many of its rows a band has (the last one may have fewer).
struct FrameShape {
  std::uint32_t width = 0, height = 0;
  std::uint32_t band_height = 0;  ///< at least 1 unless the image is empty
};

struct Band {
  std::uint32_t top = 0;
  Image image{};  ///< row 0 is the image's row `top`
  std::unique_ptr<PixelOrder> order{};
  std::size_t jobs = 0, taken = 0, done = 0;
};

class BandQueue {
 public:
  static constexpr std::size_t kInMemory = 2;  ///< bands: one is written, one rendered

  struct Job {
    Band* band = nullptr;
    std::size_t index = 0;
  };

  BandQueue(const FrameShape& shape, const BandOrders& orders, BandSink& sink);
  /// False when there are no more jobs, or after stop(). May wait for memory.
  bool next(Job& job);
  /// The job's pixels are in its band's image. May write bands.
  void finish(const Job& job);
  /// No more jobs, no more bands to the sink.
  void stop();

 private:
  void open_next();
  Band& slot(std::size_t band) { return m_slots[band % kInMemory]; }

  const FrameShape m_shape;
  const BandOrders& m_orders;
  BandSink& m_sink;
  const std::size_t m_bands;
  std::mutex m_mutex;
  std::condition_variable m_changed;
  std::vector<Band> m_slots;
  std::size_t m_opened = 0, m_written = 0;  ///< bands
  bool m_writing = false, m_stopped = false;
};

}  // namespace lentray::core
