// A whole picture: order gives pixels, camera gives rays, tracer gives colours. Threads by
// oneTBB. The picture has the same bits for every order, tester and number of threads.
#pragma once

#include <atomic>

#include "core/base/counters.h"
#include "core/image/image.h"
#include "core/render/pixel_order.h"
#include "core/render/progress.h"
#include "core/render/ray_source.h"
#include "core/render/shadow_tester.h"
#include "core/scene/scene.h"

namespace lentray::core {

struct FrameOptions {
  int threads = 0;            ///< 0: all of the machine
  bool count_tests = false;   ///< fill bounds and primitive tests (Statistics_File)
  bool alpha = false;         ///< +UA: background transparent
  /// Set from outside (a signal, another thread) to stop soon; the picture is incomplete then.
  const std::atomic<bool>* cancel = nullptr;
};

/// Renders every pixel of the order into `image` (already sized); returns the merged counts.
Counters render_frame(const Scene& scene, const RaySource& camera, const PixelOrder& order,
                      const ShadowTesterFactory& shadows, const FrameOptions& options, Image& image,
                      Progress* progress);

}  // namespace lentray::core
