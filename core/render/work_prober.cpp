#include "core/render/work_prober.h"
#include "core/trace/illumination.h"

#include <algorithm>
#include <cmath>

#include "core/render/work_meter.h"
#include "core/trace/integrator.h"

namespace lentray::core {
namespace {

/// Steps of a sequence that fills a square evenly: 1/p and 1/p^2, p^3 = p + 1.
constexpr double kAcross = 0.7548776662466927, kDown = 0.5698402909980532;
/// Places that are tried for one where the picture is not traced yet.
constexpr int kTries = 2000;
/// Samples are timed in runs that last so long, of so many at most: alone, a fast one takes several
/// times what it takes among its neighbours.
constexpr double kRun = 30e-6;
constexpr int kMostOfRun = 64;

}  // namespace

WorkProber::WorkProber(const Scene& scene, const RaySource& camera,
                       const ShadowTesterFactory& shadows, const FrameOptions& options,
                       const FilmSetup& film, const WorkCells& cells)
    : m_film(film), m_region(Film::traced_region(film)), m_cells(cells),
      m_context(scene, options.count_tests, options.illumination),
      m_tester(shadows.unwatched().make(m_context)),
      m_indirect(make_indirect_light(m_context, *m_tester)),
      m_integrator(Integrator::make(m_context, *m_tester)),
      m_sampler(camera, {options.angles, options.alpha}, *m_integrator) {
  m_clock = 1.0;
  for (int i = 0; i < 16; ++i) {
    const double start = thread_seconds();
    m_clock = std::min(m_clock, thread_seconds() - start);
  }
}

Compared WorkProber::sample(std::uint32_t column, std::uint32_t row) {
  const double corner = m_film.antialiasing.method == 2 ? -0.5 : 0.0;
  Radiance seen;
  m_sampler.sample({.column = static_cast<std::int32_t>(column),
                    .row = static_cast<std::int32_t>(row),
                    .across = corner,
                    .down = corner},
                   0, seen);
  return m_film.space.of(seen);
}

bool WorkProber::probe(WorkEstimate& estimate) {
  const double start = thread_seconds();
  for (int i = 0; i < kTries; ++i) {
    m_across = std::fmod(m_across + kAcross, 1.0);
    m_down = std::fmod(m_down + kDown, 1.0);
    const Pixel pixel{
        m_region.left + static_cast<std::uint32_t>(m_across * (m_region.right - m_region.left)),
        m_region.top + static_cast<std::uint32_t>(m_down * (m_region.bottom - m_region.top))};
    const std::size_t cell = m_cells.index(static_cast<std::int32_t>(pixel.column),
                                           static_cast<std::int32_t>(pixel.row));
    if (estimate.is_traced(cell)) continue;
    probe(pixel, cell, estimate);
    m_seconds += thread_seconds() - start;
    ++m_probes;
    return true;
  }
  return false;
}

/// The pixel, its neighbours, and further pixels of the column if they are fast.
void WorkProber::probe(const Pixel& pixel, std::size_t cell, WorkEstimate& estimate) {
  const bool compares = m_film.antialiasing.compares();
  int pairs = 0, differing = 0;
  const auto compare = [&](const Compared& a, const Compared& b) {
    ++pairs;
    if (a.distance(b) >= static_cast<float>(m_film.antialiasing.threshold)) ++differing;
  };
  double start = thread_seconds();
  const Compared here = sample(pixel.column, pixel.row);
  double spent = thread_seconds() - start - m_clock;
  int samples = 1, reads = 0;
  if (compares && !m_film.lattice.left.empty() && m_film.lattice.left[pixel.column] >= 0) {
    compare(here, sample(static_cast<std::uint32_t>(m_film.lattice.left[pixel.column]), pixel.row));
  }
  const bool is_fast = spent < kRun;
  const std::uint32_t first = pixel.row, end = std::min(m_region.bottom, first + kMostOfRun);
  if (is_fast) start = thread_seconds();
  for (std::uint32_t row = first + 1; row < end && (is_fast || (compares && row == first + 1));
       ++row) {
    const Compared below = sample(pixel.column, row);
    if (compares && row == first + 1) compare(here, below);
    if (!is_fast) break;
    samples = static_cast<int>(row - first);
    // The clock takes as long as a fast sample: it is read after 4, 8, 16 ... of them.
    const bool is_power = samples >= 4 && (samples & (samples - 1)) == 0;
    if (!is_power && row + 1 < end) continue;
    spent = thread_seconds() - start - ++reads * m_clock;
    if (spent >= kRun) break;
  }
  const Antialiasing& aa = m_film.antialiasing;
  const double samples_a_pixel = aa.method == 3 ? aa.depth * aa.depth : 1.0;
  estimate.probe(cell, std::max(spent, 0.0) / samples * samples_a_pixel, pairs, differing);
}

}  // namespace lentray::core
