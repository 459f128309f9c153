#include "core/render/work_prober.h"

#include <algorithm>
#include <cmath>

#include "core/render/tracer.h"
#include "core/render/work_meter.h"

namespace lentray::core {
namespace {

/// Steps of a sequence that fills a square evenly: 1/p and 1/p^2, p^3 = p + 1.
constexpr double kAcross = 0.7548776662466927, kDown = 0.5698402909980532;
/// Places that are tried for one where the picture is not traced yet.
constexpr int kTries = 2000;
/// Samples faster than this take longer where they come alone than after their neighbour.
constexpr double kFast = 100e-6;

}  // namespace

WorkProber::WorkProber(const Scene& scene, const RaySource& camera, const ShadowTesterFactory& shadows,
                       const FrameOptions& options, const FilmSetup& film, const WorkCells& cells)
    : m_film(film), m_region(Film::traced_region(film)), m_cells(cells),
      m_tester(shadows.unwatched().make({&scene, &m_arena, &m_counters, options.count_tests})),
      m_tracer(Tracer::make(scene, *m_tester, m_arena, m_counters, options.count_tests)),
      m_sampler(scene, camera, {options.angles, options.alpha}, *m_tracer) {
  m_counters.lights.resize(scene.lights().size());
  m_clock = 1.0;
  for (int i = 0; i < 16; ++i) {
    const double start = thread_seconds();
    m_clock = std::min(m_clock, thread_seconds() - start);
  }
}

double WorkProber::time(const Pixel& pixel, Compared& out) {
  const double corner = m_film.antialiasing.method == 2 ? -0.5 : 0.0;
  Radiance seen;
  const double start = thread_seconds();
  m_sampler.sample({.column = static_cast<std::int32_t>(pixel.column), .row = static_cast<std::int32_t>(pixel.row),
                    .across = corner, .down = corner}, 0, seen);
  const double spent = std::max(0.0, thread_seconds() - start - m_clock);
  out = m_film.space.of(seen);
  return spent;
}

bool WorkProber::probe(WorkEstimate& estimate) {
  const double start = thread_seconds();
  for (int i = 0; i < kTries; ++i) {
    m_across = std::fmod(m_across + kAcross, 1.0);
    m_down = std::fmod(m_down + kDown, 1.0);
    const Pixel pixel{m_region.left + static_cast<std::uint32_t>(m_across * (m_region.right - m_region.left)),
                      m_region.top + static_cast<std::uint32_t>(m_down * (m_region.bottom - m_region.top))};
    const std::size_t cell = m_cells.index(static_cast<std::int32_t>(pixel.column), static_cast<std::int32_t>(pixel.row));
    if (estimate.is_traced(cell)) continue;
    probe(pixel, cell, estimate);
    m_seconds += thread_seconds() - start;
    ++m_probes;
    return true;
  }
  return false;
}

void WorkProber::probe(const Pixel& pixel, std::size_t cell, WorkEstimate& estimate) {
  const std::int32_t left =
      m_film.lattice.left.empty() ? static_cast<std::int32_t>(pixel.column) - 1 : m_film.lattice.left[pixel.column];
  const Pixel beside{static_cast<std::uint32_t>(std::max(left, 0)), pixel.row};
  Compared here, other;
  if (m_film.antialiasing.method == 0) {
    double spent = time(pixel, here);
    if (spent < kFast) spent = time(left >= 0 ? beside : pixel, other);
    estimate.probe(cell, spent, 0, 0);
    return;
  }
  int pairs = 0, differing = 0;
  const auto compare = [&] {
    ++pairs;
    if (here.distance(other) >= static_cast<float>(m_film.antialiasing.threshold)) ++differing;
  };
  double spent = time(pixel, here);
  if (pixel.row > 0) {
    spent = time({pixel.column, pixel.row - 1}, other);
    compare();
  }
  if (left >= 0) {
    spent = time(beside, other);
    compare();
  }
  estimate.probe(cell, spent, pairs, differing);
}

}  // namespace lentray::core
