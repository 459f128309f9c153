#include "core/render/frame_progress.h"

#include <algorithm>

#include "core/render/film.h"

namespace lentray::core {
namespace {

/// Of the pixels, antialiased: a guess until some are.
constexpr double kAntialiased = 0.2;

double pixels_to_visit(const FilmSetup& film, std::size_t stage) {
  const PixelRegion region = Film::traced_region(film);
  const PixelSet* known = film.known(stage);
  if (!known) return 1.0 * (region.right - region.left) * (region.bottom - region.top);
  double pixels = 0.0;
  for (std::uint32_t row = region.top; row < region.bottom; ++row) {
    for (std::uint32_t k = region.left; k < region.right; ++k) {
      if (!known->has({k, row})) pixels += 1.0;
    }
  }
  return pixels;
}

}  // namespace

FrameProgress::FrameProgress(Progress& listener, const FilmSetup& film, Clock::time_point start)
    : m_listener(listener), m_start(start),
      m_next(std::chrono::duration_cast<Clock::duration>(Progress::kSilence).count()) {
  m_stages[0].all = pixels_to_visit(film, 0);
  m_stages[0].guess = 1.0;
  if (!film.antialiasing.compares()) return;
  m_stages[1].all = pixels_to_visit(film, 1);
  m_stages[1].guess = kAntialiased * film.antialiasing.more_samples();
}

void FrameProgress::add(std::size_t stage, std::uint64_t pixels, Clock::duration spent,
                        Clock::time_point now) {
  m_stages[stage].visited.fetch_add(pixels, std::memory_order_relaxed);
  m_stages[stage].spent.fetch_add(spent.count(), std::memory_order_relaxed);
  const Clock::rep time = (now - m_start).count();
  Clock::rep next = m_next.load(std::memory_order_relaxed);
  const Clock::rep later =
      time + std::chrono::duration_cast<Clock::duration>(Progress::kBetween).count();
  if (time >= next && m_next.compare_exchange_strong(next, later)) tell(now);
}

void FrameProgress::tell(Clock::time_point now) {
  double done = 0.0, left = 0.0, plain = 0.0;
  for (const Stage& stage : m_stages) {
    const auto visited = static_cast<double>(stage.visited.load(std::memory_order_relaxed));
    const auto spent = static_cast<double>(stage.spent.load(std::memory_order_relaxed));
    const double pixel = visited > 0.0 ? spent / visited : stage.guess * plain;
    if (&stage == m_stages.data()) plain = pixel;
    done += spent;
    left += pixel * std::max(0.0, stage.all - visited);
  }
  if (done <= 0.0) return;
  m_listener.advance(done / (done + left),
                     std::chrono::duration<double>(now - m_start).count() * left / done);
}

}  // namespace lentray::core
