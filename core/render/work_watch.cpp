#include "core/render/work_watch.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "core/base/deep_threads.h"
#include "core/render/work_estimate.h"
#include "core/render/work_pace.h"
#include "core/render/work_prober.h"

namespace lentray::core {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kFirst = 1.0;     ///< seconds without a bar
constexpr double kReports = 0.2;   ///< seconds between two reports
constexpr double kProbing = 0.1;   ///< seconds of probing without a look at what is left
constexpr int kLeastProbes = 150;  ///< before anything is said
/// Of all work: what probes may take at first, and in all.
constexpr double kFirstShare = 0.004, kShare = 0.008;

double since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// How often stage 0 visits a pixel: bands trace rows of the next band for its neighbours.
double repeats(const Antialiasing& antialiasing, std::uint32_t band_height,
               const PixelRegion& region) {
  if (!antialiasing.compares() || band_height >= region.bottom - region.top) return 1.0;
  return 1.0 + (antialiasing.method == 1 ? 2.0 : 1.0) / band_height;
}

/// At the end threads have nothing to do while others finish their jobs: half of a long job, on
/// average; and a job takes its one thread as long as it takes.
double seconds_left(const WorkEstimate::Work& work, const WorkPace& pace, unsigned threads,
                    double now) {
  const double one_thread = std::max(1.0, work.done > 0.0 ? threads * now / work.done : 1.0);
  const double longest = one_thread * work.longest;
  return std::max(longest, pace.seconds(work.left) + 0.5 * longest * (threads - 1.0) / threads);
}

}  // namespace

WorkWatch::WorkWatch(const Scene& scene, const RaySource& camera,
                     const ShadowTesterFactory& shadows, const FrameOptions& options,
                     FilmSetup film, std::uint32_t band_height, Progress& progress)
    : m_scene(scene), m_camera(camera), m_shadows(shadows), m_options(options),
      m_film(std::move(film)), m_band_height(band_height), m_progress(progress),
      m_cells(Film::traced_region(m_film)), m_thread() {
  for (std::size_t stage = 0; stage < WorkCells::kStages; ++stage) {
    if (const PixelSet* known = m_film.known(stage)) m_cells.leave_out(*known, stage);
  }
  m_thread = std::jthread([this](std::stop_token stop) {
    run_on_threads(1, m_scene.deepest(), [this, &stop] { run(std::move(stop)); });
  });
}

WorkWatch::~WorkWatch() {
  m_thread.request_stop();
  m_thread.join();
}

bool WorkWatch::wait(std::stop_token& stop, double seconds) {
  std::unique_lock lock(m_mutex);
  m_ended.wait_for(lock, stop, std::chrono::duration<double>(seconds), [] { return false; });
  return !stop.stop_requested();
}

void WorkWatch::run(std::stop_token stop) {
  if (own_stack().levels() < m_scene.deepest()) return;  // the system gives no stack for probes
  try {
    follow(stop);
  } catch (...) {
    // A ray that fails ends the frame when a thread comes to it, with that thread's failure.
  }
}

void WorkWatch::follow(std::stop_token& stop) {
  const Clock::time_point start = Clock::now();
  if (!wait(stop, kFirst)) return;
  WorkEstimate estimate(m_cells, FinerWork::of(m_film.antialiasing),
                        repeats(m_film.antialiasing, m_band_height, Film::traced_region(m_film)));
  WorkProber prober(m_scene, m_camera, m_shadows, m_options, m_film, m_cells);
  WorkPace pace;
  const unsigned threads = frame_threads(m_options);
  do {
    const WorkEstimate::Work work = estimate.work();
    const double now = since(start);
    pace.add(now, work.done);
    if (prober.probes() >= kLeastProbes) {
      m_progress.advance(work.fraction(), seconds_left(work, pace, threads, now));
    }
    const double allowed =
        kFirstShare * (work.done + work.left) + (kShare - kFirstShare) * work.done;
    bool is_more = true;
    while (is_more && !stop.stop_requested() && since(start) < now + kProbing &&
           (prober.seconds() < allowed || prober.probes() < kLeastProbes)) {
      is_more = prober.probe(estimate);
    }
    if (since(start) >= now + kProbing && prober.probes() < kLeastProbes) continue;
    if (!wait(stop, std::max(0.0, kReports - (since(start) - now)))) return;
  } while (!stop.stop_requested());
}

}  // namespace lentray::core
