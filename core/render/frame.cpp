#include "core/render/frame.h"

#include <algorithm>
#include <cstddef>
#include <exception>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "core/render/tracer.h"

namespace lentray::core {
namespace {

/// What all threads of a frame share.
struct Work {
  const Scene& scene;
  const RaySource& camera;
  const ShadowTesterFactory& shadows;
  const FrameOptions& options;
  Progress* progress;
  BandQueue queue;
  const double pixels;
  std::atomic<std::size_t> pixels_done{0};
  std::mutex merge{};
  Counters total{};
  std::exception_ptr failure{};

  bool cancelled() const {
    return options.cancel && options.cancel->load(std::memory_order_relaxed);
  }
};

/// A pixel as the image keeps it: not premultiplied, and with alpha the background taken out.
void store(const Radiance& seen, const Work& work, float* out) {
  Rgb rgb = seen.rgb;
  float alpha = 1.0f;
  if (work.options.alpha) {
    alpha = std::clamp(1.0f - seen.transmit, 0.0f, 1.0f);
    rgb -= work.scene.settings().background.rgb * seen.transmit;
    rgb = alpha > 0.0f ? rgb * (1.0f / alpha) : Rgb{};
  }
  out[0] = rgb.r;
  out[1] = rgb.g;
  out[2] = rgb.b;
  out[3] = alpha;
}

/// False if the frame was cancelled meanwhile.
bool render_job(const Work& work, const BandQueue::Job& job, std::vector<Pixel>& pixels,
                Tracer& tracer, Counters& counters) {
  job.band->order->pixels(job.index, pixels);
  for (const Pixel& pixel : pixels) {
    if (work.cancelled()) return false;
    Ray ray;
    Radiance seen;
    if (work.camera.ray(pixel.column + 0.5, pixel.row + 0.5, ray)) {
      seen = tracer.trace(ray, pixel);
    } else {
      ++counters.dark_pixels;
    }
    store(seen, work, job.band->image.pixel(pixel.column, pixel.row - job.band->top));
  }
  return true;
}

/// One thread's share: takes jobs in order while there are any.
void take_jobs(Work& work) {
  Counters counters;
  counters.lights.resize(work.scene.lights().size());
  HitArena arena;
  const std::unique_ptr<ShadowTester> tester =
      work.shadows.make({&work.scene, &arena, &counters, work.options.count_tests});
  const std::unique_ptr<Tracer> tracer =
      Tracer::make(work.scene, *tester, arena, counters, work.options.count_tests);
  std::vector<Pixel> pixels;
  BandQueue::Job job;
  while (work.queue.next(job)) {
    if (!render_job(work, job, pixels, *tracer, counters)) {
      work.queue.stop();
      break;
    }
    work.queue.finish(job);
    const std::size_t done = work.pixels_done.fetch_add(pixels.size()) + pixels.size();
    if (work.progress) work.progress->advance(static_cast<double>(done) / work.pixels);
  }
  const std::lock_guard lock(work.merge);
  work.total.merge(counters);
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

double bytes_a_band_row(std::uint32_t width) {
  return static_cast<double>(BandQueue::kInMemory * 4 * sizeof(float)) * width;
}

Counters render_frame(const Scene& scene, const RaySource& camera, const FrameShape& shape,
                      const BandOrders& orders, const ShadowTesterFactory& shadows,
                      const FrameOptions& options, BandSink& sink, Progress* progress) {
  Work work{scene,    camera,   shadows, options,
            progress, BandQueue(shape, orders, sink), 1.0 * shape.width * shape.height};
  const unsigned machine = std::max(1u, std::thread::hardware_concurrency());
  const unsigned threads = options.threads > 0 ? static_cast<unsigned>(options.threads) : machine;
  {
    // Not tasks of oneTBB: as many as asked for must run at once, and they wait for each other.
    std::vector<std::jthread> others;
    for (unsigned i = 1; i < threads; ++i) others.emplace_back([&work] { run(work); });
    run(work);
  }
  if (work.failure) std::rethrow_exception(work.failure);
  return std::move(work.total);
}

}  // namespace lentray::core
