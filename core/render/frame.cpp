#include "core/render/frame.h"

#include <algorithm>
#include <exception>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "core/base/deep_threads.h"
#include "core/render/frame_progress.h"
#include "core/trace/first_hits.h"
#include "core/trace/illumination.h"
#include "core/trace/indirect_light.h"
#include "core/trace/integrator.h"
#include "core/trace/thread_context.h"

namespace lentray::core {
namespace {

/// What all threads of a frame share.
struct Work {
  const Scene& scene;
  const RaySource& camera;
  const ShadowTesterFactory& shadows;
  const FrameOptions& options;
  FrameProgress* progress;  ///< null: nobody asks for the progress
  BandQueue queue;
  std::mutex merge{};
  Counters total{};
  std::exception_ptr failure{};
};

PixelRegion region_of(const FrameShape& shape, const FrameOptions& options) {
  return options.region.value_or(PixelRegion{0, 0, shape.width, shape.height});
}

/// 0: sRGB, see ComparedSpace.
double working_gamma(const SceneSettings& settings) {
  if (settings.assumed_gamma > 0.0) return settings.assumed_gamma;
  return settings.assumed_gamma_set ? 0.0 : 1.0;
}

FilmSetup film_setup(const Scene* scene, const RaySource& camera, const FrameShape& shape,
                     const FrameOptions& options) {
  FilmSetup setup;
  setup.width = shape.width;
  setup.height = shape.height;
  setup.region = region_of(shape, options);
  setup.antialiasing = options.antialiasing;
  setup.alpha = options.alpha;
  setup.ledger = options.ledger;
  setup.camera = &camera;
  if (options.antialiasing.compares()) setup.lattice = camera.lattice(shape.width);
  if (!scene) return setup;
  const double gamma = working_gamma(scene->settings());
  setup.space = {options.antialiasing.gamma, gamma};
  setup.light = {gamma, options.antialiasing.most};
  return setup;
}

/// One thread's share: takes jobs in order while there are any.
void take_jobs(Work& work) {
  ThreadContext context(work.scene, work.options.count_tests, work.options.illumination);
  const std::unique_ptr<ShadowTester> tester = work.shadows.make(context);
  const std::unique_ptr<IndirectLight> indirect = make_indirect_light(context, *tester);
  Integrator integrator(context, *tester);
  std::optional<FirstHits> hits;
  std::optional<RayWaves> waves;
  if (work.options.bundles) {
    hits.emplace(context);
    waves.emplace(context, integrator, *tester);
  }
  static constexpr std::atomic<bool> kNever{false};
  const std::atomic<bool>& cancel = work.options.cancel ? *work.options.cancel : kNever;
  Sampler sampler(work.camera, {work.options.angles, work.options.alpha}, integrator,
                  hits ? &*hits : nullptr, waves ? &*waves : nullptr, cancel);
  std::optional<FrameMeter> meter;
  if (work.progress) meter.emplace(*work.progress);
  FilmThread thread{.sampler = sampler,
                    .counters = context.counters,
                    .cancel = cancel,
                    .meter = meter ? &*meter : nullptr};
  BandQueue::Job job;
  while (work.queue.next(job)) {
    if (meter) meter->begin(job.band->film->ledger_stage(job.stage));
    if (!job.band->film->work(job.stage, job.index, thread)) {
      work.queue.stop();
      break;
    }
    if (meter) meter->end();
    work.queue.finish(job);
  }
  const std::lock_guard lock(work.merge);
  work.total.merge(context.counters);
}

/// The same; others do not wait for a thread that failed, and the first failure is kept.
void run(Work& work) {
  try {
    take_jobs(work);
  } catch (...) {
    work.queue.stop();
    const std::lock_guard lock(work.merge);
    if (!work.failure) work.failure = std::current_exception();
  }
}

}  // namespace

unsigned frame_threads(const FrameOptions& options) {
  return options.threads > 0 ? static_cast<unsigned>(options.threads)
                             : std::max(1u, std::thread::hardware_concurrency());
}

double bytes_a_band_row(const Antialiasing& antialiasing, std::uint32_t width) {
  return BandQueue::kInMemory * Film::bytes_a_row(antialiasing, width);
}

FilmColumns traced_columns(const RaySource& camera, const FrameShape& shape,
                           const FrameOptions& options) {
  return Film::traced_columns(film_setup(nullptr, camera, shape, options));
}

Counters render_frame(const Scene& scene, const RaySource& camera, const FrameShape& shape,
                      const BandOrders& orders, const ShadowTesterFactory& shadows,
                      const FrameOptions& options, BandSink& sink, Progress* progress) {
  FrameShape bands = shape;
  bands.is_whole = !options.region;
  const std::uint32_t grain = Film::rows_together(options.antialiasing);
  bands.band_height = std::max(1u, (shape.band_height + grain - 1) / grain) * grain;
  const FilmSetup setup = film_setup(&scene, camera, shape, options);
  const auto film = Film::make(setup, orders);
  std::optional<FrameProgress> watch;
  if (progress) watch.emplace(*progress, setup);
  Work work{
      scene, camera, shadows, options, watch ? &*watch : nullptr, BandQueue(bands, *film, sink)};
  // Not tasks of oneTBB: they wait for each other.
  run_on_threads(frame_threads(options), scene.deepest(), [&work] { run(work); });
  if (work.failure) std::rethrow_exception(work.failure);
  if (progress && !(options.cancel && options.cancel->load())) progress->advance(1.0, 0.0);
  return std::move(work.total);
}

}  // namespace lentray::core
