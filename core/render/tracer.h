// Colours of rays: Whitted ray tracing with POV-Ray's shading model. One Tracer a thread.
// Space: world; colours linear. Source: reference manual 3.7, "Finish", "Interior",
// "Global Settings"; constants measured on stock with tests/image.
#pragma once

#include <bit>
#include <cstdint>
#include <memory>

#include "core/base/color.h"
#include "core/base/counters.h"
#include "core/base/ray.h"
#include "core/render/pixel_order.h"
#include "core/render/shadow_tester.h"
#include "core/scene/scene.h"

namespace lentray::core {

struct Radiance {
  Rgb rgb;
  float transmit = 0.0f;  ///< of the picture's background, with +UA (1 - alpha); rgb is premultiplied
};

class Tracer {
 public:
  virtual ~Tracer() = default;
  /// The colour along a camera ray of a pixel; `key` is the sample's (core/render/random_key.h).
  virtual Radiance trace(const Ray& ray, Pixel pixel, std::uint64_t key) = 0;
  /// Of the pixel's sample 0.
  Radiance trace(const Ray& ray, Pixel pixel) {
    static_assert(std::endian::native == std::endian::little);  // sample_key() of a pixel is its bits
    return trace(ray, pixel, std::bit_cast<std::uint64_t>(pixel));
  }
  /// Picks the specialised tracer that scene.needs() allows (the general one if the scene was
  /// compiled with general_path). All give the same bits.
  static std::unique_ptr<Tracer> make(const Scene& scene, ShadowTester& shadows, HitArena& arena,
                                      Counters& counters, bool count_tests);
};

}  // namespace lentray::core
