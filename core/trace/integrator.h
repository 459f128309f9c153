// The light that a camera ray brings: recursive (Whitted) ray tracing with POV-Ray's shading model.
// World space; colours linear. One a thread.
// Source: reference manual 3.7, "Finish", "Interior", "Global Settings"; constants measured on stock
// with tests/image.
#pragma once

#include <bit>
#include <cstdint>
#include <limits>
#include <memory>

#include "core/base/pixel.h"
#include "core/base/ray.h"
#include "core/trace/follow.h"
#include "core/trace/radiance.h"
#include "core/trace/shadow_tester.h"

namespace lentray::core {

struct PathRules;
struct ThreadContext;

/// A ray that gathers light for a place (core/trace/indirect_light.h).
struct GatherRay {
  Ray ray;  ///< unit
  float weight;
  int level;                      ///< levels above it
  float least_importance = 0.0f;  ///< of what it may meet: less is not shaded
  std::uint64_t key = 0;          ///< of its random numbers
  std::uint8_t scattered = 0;     ///< as RayState's
};
struct GatheredRay {
  Rgb light;
  double distance = std::numeric_limits<double>::infinity();  ///< to what it met
  float importance = 1.0f;                                    ///< of that
};

class Integrator : public Follow {
 public:
  /// The light along a camera ray of a pixel; `key` is the sample's (core/trace/random_key.h).
  virtual Radiance trace(const Ray& ray, Pixel pixel, std::uint64_t key) = 0;
  /// Of the pixel's sample 0.
  Radiance trace(const Ray& ray, Pixel pixel) {
    static_assert(std::endian::native ==
                  std::endian::little);  // sample_key() of a pixel is its bits
    return trace(ray, pixel, std::bit_cast<std::uint64_t>(pixel));
  }
  /// The light along a ray that gathers.
  virtual GatheredRay gather(const GatherRay& ray) = 0;
  /// Specialised to what the context's scene needs (the general one if the scene was compiled with
  /// general_path). All give the same bits. `shadows` works with the same context.
  static std::unique_ptr<Integrator> make(ThreadContext& context, ShadowTester& shadows);
  static std::unique_ptr<Integrator> make(ThreadContext& context, ShadowTester& shadows,
                                          const PathRules& rules);
};

}  // namespace lentray::core
