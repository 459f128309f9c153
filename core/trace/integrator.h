// The light that a ray brings: recursive (Whitted) ray tracing, depth first. World space; colours linear. One a
// thread; no allocation per ray once its buffers have grown.
// Source: reference manual 3.7, "Finish", "Interior", "Global Settings"; constants measured on stock
// with tests/image.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/base/pixel.h"
#include "core/base/ray.h"
#include "core/trace/gather_ray.h"
#include "core/trace/radiance.h"
#include "core/trace/ray_stepper.h"
#include "core/trace/shadow_tester.h"

namespace lentray::core {

class Integrator {
 public:
  /// It leaves out what the context's scene does not need. `shadows` works with the same context.
  Integrator(ThreadContext& context, ShadowTester& shadows);
  Integrator(ThreadContext& context, ShadowTester& shadows, const PathRules& rules);
  Integrator(const Integrator&) = delete;
  Integrator& operator=(const Integrator&) = delete;

  /// The light along a camera ray of a pixel; `key` is the sample's (core/trace/random_key.h).
  Radiance trace(const Ray& ray, Pixel pixel, std::uint64_t key);
  /// The same of a ray that is known to meet this first; null: nothing.
  Radiance trace_met(const Ray& ray, Pixel pixel, std::uint64_t key, const Hit* hit);
  /// Of the pixel's sample 0.
  Radiance trace(const Ray& ray, Pixel pixel) {
    static_assert(std::endian::native ==
                  std::endian::little);  // sample_key() of a pixel is its bits
    return trace(ray, pixel, std::bit_cast<std::uint64_t>(pixel));
  }
  /// What a ray brings that goes on from another, with so many before it on its way.
  Radiance follow_from(const RayState& state, std::size_t depth);
  RayStepper& stepper() { return m_stepper; }
  /// The light along a ray that is not the camera's. The ray itself sees whatever its weight and level are;
  /// what goes on from there ends where that of camera rays does. It may be asked while a ray is traced. Who asks
  /// outside of a sample that is traced begins the context's indirect light itself.
  GatheredRay gather(const GatherRay& ray);

 private:
  RayState begin(const Ray& ray, Pixel pixel, std::uint64_t key);
  Radiance follow(const RayState& state);
  /// The same without a call: most pictures have little more than camera rays.
  Radiance follow_here(const RayState& state);
  /// Whether the ray would be one too many on the way, which is counted.
  bool is_too_deep();
  RayRecord& enter_ray();
  /// What the ray brings, once its record is filled.
  Radiance leave_ray(const RayState& state, const RayRecord& record);

  ThreadContext& m_context;
  RayStepper m_stepper;
  std::vector<std::unique_ptr<RayRecord>> m_records;  ///< one a ray on the way
  std::size_t m_depth = 0;                            ///< rays on the way
};

}  // namespace lentray::core
