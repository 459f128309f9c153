// A whole picture: a film asks for samples (core/render/film.h), a sampler makes them of rays
// (core/render/sampler.h), a tracer gives the rays' light, finished bands of rows go to a sink.
// The picture has the same bits for every order, tester, band height and number of threads.
#pragma once

#include <atomic>
#include <optional>

#include "core/base/counters.h"
#include "core/render/band_queue.h"
#include "core/render/band_sink.h"
#include "core/render/picture_ledger.h"
#include "core/render/pixel_order.h"
#include "core/render/progress.h"
#include "core/render/ray_source.h"
#include "core/scene/scene.h"
#include "core/trace/shadow_tester.h"

namespace lentray::core {

struct Illumination;

struct FrameOptions {
  int threads = 0;           ///< 0: all of the machine
  bool count_tests = false;  ///< fill bounds and primitive tests (Statistics_File)
  bool alpha = false;        ///< +UA, for a scene with SceneSettings::alpha
  Antialiasing antialiasing{};
  bool bundles = true;  ///< rays of neighbouring pixels are searched together: the same bits
  int angles = 1;       ///< Antialias_Angle, see SamplerOptions
  const Illumination* illumination = nullptr;  ///< what passes left (core/pass); null: none
  std::optional<PixelRegion> region{};  ///< the pixels that are rendered; the others are black
  PictureLedger* ledger =
      nullptr;  ///< what is known of the picture, and what becomes known; or null
  /// Set from outside (a signal, another thread) to stop soon; the sink then lacks bands.
  const std::atomic<bool>* cancel = nullptr;
};

/// How many threads a frame takes.
unsigned frame_threads(const FrameOptions& options);
/// Bytes that render_frame() holds for each row of a band.
double bytes_a_band_row(const Antialiasing& antialiasing, std::uint32_t width);
/// The columns that `orders` are to have, and the rows of which a band must be a multiple.
FilmColumns traced_columns(const RaySource& camera, const FrameShape& shape,
                           const FrameOptions& options);

/// Renders every pixel; returns the merged counts. `progress` (or null) hears nothing in the first
/// second, then several times a second, and the end.
Counters render_frame(const Scene& scene, const RaySource& camera, const FrameShape& shape,
                      const BandOrders& orders, const ShadowTesterFactory& shadows,
                      const FrameOptions& options, BandSink& sink, Progress* progress);

}  // namespace lentray::core
