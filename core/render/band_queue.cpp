#include "core/render/band_queue.h"

#include <algorithm>
#include <cassert>

namespace lentray::core {
namespace {

std::size_t bands_of(const FrameShape& shape) {
  if (shape.width == 0 || shape.height == 0) return 0;
  return (std::size_t{shape.height} + shape.band_height - 1) / shape.band_height;
}

}  // namespace

BandQueue::BandQueue(const FrameShape& shape, const Film& film, BandSink& sink)
    : m_shape(shape), m_film(film), m_sink(sink), m_bands(bands_of(shape)),
      m_slots(std::min(kInMemory, std::max<std::size_t>(m_bands, 1))) {}

bool BandQueue::take(Job& job) {
  for (std::size_t i = m_written; i < m_opened; ++i) {
    Band& band = slot(i);
    if (band.taken == band.jobs) continue;
    job = {&band, band.stage, band.taken++};
    return true;
  }
  return false;
}

bool BandQueue::next(Job& job) {
  std::unique_lock lock(m_mutex);
  for (;;) {
    if (m_stopped) return false;
    if (take(job)) return true;
    if (m_opened < m_bands && m_opened - m_written < kInMemory) {
      open_next();
      if (slot(m_opened - 1).is_done()) write_done(lock);
    } else if (m_opened == m_bands && all_given()) {
      return false;
    } else {
      m_changed.wait(lock);
    }
  }
}

bool BandQueue::all_given() {
  for (std::size_t i = m_written; i < m_opened; ++i) {
    const Band& band = slot(i);
    if (!band.is_done() && band.stage + 1 < band.stages) return false;
  }
  return true;
}

void BandQueue::open_next() {
  const std::size_t top = m_opened * m_shape.band_height;
  const std::size_t bottom = std::min<std::size_t>(top + m_shape.band_height, m_shape.height);
  Band& band = slot(m_opened);
  band.top = static_cast<std::uint32_t>(top);
  band.image.width = m_shape.width;
  band.image.height = static_cast<std::uint32_t>(bottom - top);
  band.image.rgba.resize(std::size_t{4} * m_shape.width * (bottom - top));
  if (!m_shape.is_whole) std::fill(band.image.rgba.begin(), band.image.rgba.end(), 0.0f);
  band.film = m_film.band(band.top, static_cast<std::uint32_t>(bottom), band.image);
  band.stages = band.film ? band.film->stages() : 0;
  band.stage = 0;
  band.jobs = band.taken = band.done = 0;
  begin_stage(band);
  ++m_opened;
}

/// Stages without jobs are done at once.
void BandQueue::begin_stage(Band& band) {
  while (!band.is_done()) {
    band.jobs = band.film->jobs(band.stage);
    band.taken = band.done = 0;
    if (band.jobs > 0) return;
    ++band.stage;
  }
  band.film.reset();  // what it keeps for itself is needed no longer
}

void BandQueue::finish(const Job& job) {
  std::unique_lock lock(m_mutex);
  Band& band = *job.band;
  assert(band.done < band.taken && job.stage == band.stage);
  if (++band.done < band.jobs) return;
  ++band.stage;
  begin_stage(band);
  if (band.is_done()) {
    write_done(lock);
  } else {
    m_changed.notify_all();
  }
}

void BandQueue::write_done(std::unique_lock<std::mutex>& lock) {
  if (m_writing) return;
  // Whoever is writing takes the bands along that were finished meanwhile.
  m_writing = true;
  while (!m_stopped && m_written < m_opened && slot(m_written).is_done()) {
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
