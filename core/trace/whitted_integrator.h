// The integrator behind Integrator::make: follows a camera ray and all that goes on from it, depth
// first. One a thread; no allocation per ray once its buffers have grown.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "core/base/deep_threads.h"
#include "core/trace/integrator.h"
#include "core/trace/ray_stepper.h"

namespace lentray::core {

template <unsigned kFeatures>
class WhittedIntegrator final : public Integrator {
 public:
  WhittedIntegrator(ThreadContext& context, ShadowTester& shadows, const PathRules& rules)
      : m_context(context), m_stepper(context, shadows, rules) {}

  using Integrator::trace;
  Radiance trace(const Ray& ray, Pixel pixel, std::uint64_t key) override;
  GatheredRay gather(const GatherRay& ray) override;

 private:
  Radiance follow(const RayState& state);
  /// The same without a call: most pictures have little more than camera rays.
  Radiance follow_here(const RayState& state);
  RayRecord& enter_ray();
  /// What the ray brings, once its record is filled.
  Radiance leave_ray(const RayState& state, const RayRecord& record);

  ThreadContext& m_context;
  RayStepper<kFeatures> m_stepper;
  std::vector<std::unique_ptr<RayRecord>> m_records;                ///< one a ray on the way
  std::size_t m_depth = 0;                                          ///< rays on the way
  std::size_t m_deepest = std::numeric_limits<std::size_t>::max();  ///< known when the stack ends
  const std::uintptr_t m_stack_end = own_stack().middle();
};

/// The path of exactly these features (a superset of what the scene needs); for Integrator::make and
/// for the test that paths agree.
std::unique_ptr<Integrator> make_whitted_integrator(unsigned features, ThreadContext& context,
                                                    ShadowTester& shadows, const PathRules& rules);

}  // namespace lentray::core
