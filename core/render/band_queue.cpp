#include "core/render/band_queue.h"

#include <algorithm>

namespace lentray::core {
namespace {

std::size_t bands_of(const FrameShape& shape) {
  if (shape.width == 0 || shape.height == 0) return 0;
  return (std::size_t{shape.height} + shape.band_height - 1) / shape.band_height;
}

}  // namespace

BandQueue::BandQueue(const FrameShape& shape, const BandOrders& orders, BandSink& sink)
    : m_shape(shape), m_orders(orders), m_sink(sink), m_bands(bands_of(shape)),
      m_slots(std::min(kInMemory, std::max<std::size_t>(m_bands, 1))) {}

bool BandQueue::next(Job& job) {
  std::unique_lock lock(m_mutex);
  for (;;) {
    if (m_stopped) return false;
    if (m_opened > 0) {
      Band& band = slot(m_opened - 1);
      if (band.taken < band.jobs) {
        job = {&band, band.taken++};
        return true;
      }
    }
    if (m_opened == m_bands) return false;
    if (m_opened - m_written < kInMemory) {
      open_next();
    } else {
      m_changed.wait(lock);
    }
  }
}

void BandQueue::open_next() {
  const std::size_t top = m_opened * m_shape.band_height;
  const std::size_t bottom = std::min<std::size_t>(top + m_shape.band_height, m_shape.height);
  Band& band = slot(m_opened);
  band.top = static_cast<std::uint32_t>(top);
  band.image.width = m_shape.width;
  band.image.height = static_cast<std::uint32_t>(bottom - top);
  band.image.rgba.resize(std::size_t{4} * m_shape.width * (bottom - top));
  band.order = m_orders.band(band.top, static_cast<std::uint32_t>(bottom));
  band.jobs = band.order->jobs();
  band.taken = band.done = 0;
  ++m_opened;
}

void BandQueue::finish(const Job& job) {
  std::unique_lock lock(m_mutex);
  if (++job.band->done < job.band->jobs || m_writing) return;
  // Whoever is writing takes the bands along that were finished meanwhile.
  m_writing = true;
  while (!m_stopped && m_written < m_opened && slot(m_written).done == slot(m_written).jobs) {
    const Band& band = slot(m_written);
    lock.unlock();
    m_sink.put(band.image, band.top);
    lock.lock();
    ++m_written;
    m_changed.notify_all();
  }
  m_writing = false;
}

void BandQueue::stop() {
  const std::lock_guard lock(m_mutex);
  m_stopped = true;
  m_changed.notify_all();
}

}  // namespace lentray::core
