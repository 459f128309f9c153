#include "core/render/frame.h"

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "core/render/tracer.h"

namespace lentray::core {
namespace {

/// What all threads of a frame share.
struct Work {
  const Scene& scene;
  const RaySource& camera;
  const PixelOrder& order;
  const ShadowTesterFactory& shadows;
  const FrameOptions& options;
  Image& image;
  Progress* progress;
  std::size_t jobs;
  std::atomic<std::size_t> next{0};
  std::atomic<std::size_t> done{0};
  std::mutex merge{};
  Counters total{};

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

/// One thread's share: takes jobs in order while there are any.
void run(Work& work) {
  Counters counters;
  counters.lights.resize(work.scene.lights().size());
  HitArena arena;
  const std::unique_ptr<ShadowTester> tester =
      work.shadows.make({&work.scene, &arena, &counters, work.options.count_tests});
  const std::unique_ptr<Tracer> tracer =
      Tracer::make(work.scene, *tester, arena, counters, work.options.count_tests);
  std::vector<Pixel> pixels;
  for (;;) {
    const std::size_t job = work.next.fetch_add(1, std::memory_order_relaxed);
    if (job >= work.jobs || work.cancelled()) break;
    work.order.pixels(job, pixels);
    for (const Pixel& pixel : pixels) {
      Ray ray;
      Radiance seen;
      if (work.camera.ray(pixel.column + 0.5, pixel.row + 0.5, ray)) {
        seen = tracer->trace(ray, pixel);
      } else {
        ++counters.dark_pixels;
      }
      store(seen, work, work.image.pixel(pixel.column, pixel.row));
      if (work.cancelled()) break;
    }
    const std::size_t done = work.done.fetch_add(1, std::memory_order_relaxed) + 1;
    if (work.progress) {
      work.progress->advance(static_cast<double>(done) / static_cast<double>(work.jobs));
    }
  }
  const std::lock_guard lock(work.merge);
  work.total.merge(counters);
}

}  // namespace

Counters render_frame(const Scene& scene, const RaySource& camera, const PixelOrder& order,
                      const ShadowTesterFactory& shadows, const FrameOptions& options,
                      Image& image, Progress* progress) {
  Work work{scene, camera, order, shadows, options, image, progress, order.jobs()};
  const int threads =
      options.threads > 0 ? options.threads : std::max(1, tbb::info::default_concurrency());
  // More threads than the machine has are allowed when asked for.
  std::optional<tbb::global_control> more;
  if (threads > tbb::info::default_concurrency()) {
    more.emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
  }
  tbb::task_arena arena(threads);
  arena.execute([&] {
    tbb::task_group group;
    for (int i = 1; i < threads; ++i) group.run([&] { run(work); });
    group.run_and_wait([&] { run(work); });
  });
  return std::move(work.total);
}

}  // namespace lentray::core
