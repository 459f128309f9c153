// The light that a camera ray brings, or another ray (core/trace/follow.h): recursive (Whitted) ray
// tracing. World space; colours linear. One a thread.
// Source: reference manual 3.7, "Finish", "Interior", "Global Settings"; constants measured on stock
// with tests/image.
#pragma once

#include <bit>
#include <cstdint>
#include <memory>

#include "core/base/pixel.h"
#include "core/base/ray.h"
#include "core/trace/follow.h"
#include "core/trace/radiance.h"
#include "core/trace/shadow_tester.h"

namespace lentray::core {

struct Hit;
struct PathRules;
struct ThreadContext;

class Integrator : public Follow {
 public:
  /// The light along a camera ray of a pixel; `key` is the sample's (core/trace/random_key.h).
  virtual Radiance trace(const Ray& ray, Pixel pixel, std::uint64_t key) = 0;
  /// The same of a ray that is known to meet this first; null: nothing.
  virtual Radiance trace_met(const Ray& ray, Pixel pixel, std::uint64_t key, const Hit* hit) = 0;
  /// Of the pixel's sample 0.
  Radiance trace(const Ray& ray, Pixel pixel) {
    static_assert(std::endian::native ==
                  std::endian::little);  // sample_key() of a pixel is its bits
    return trace(ray, pixel, std::bit_cast<std::uint64_t>(pixel));
  }
  Radiance trace_met(const Ray& ray, Pixel pixel, const Hit* hit) {
    return trace_met(ray, pixel, std::bit_cast<std::uint64_t>(pixel), hit);
  }
  /// It leaves out what the context's scene does not need. `shadows` works with the same context.
  static std::unique_ptr<Integrator> make(ThreadContext& context, ShadowTester& shadows);
  static std::unique_ptr<Integrator> make(ThreadContext& context, ShadowTester& shadows,
                                          const PathRules& rules);
};

}  // namespace lentray::core
