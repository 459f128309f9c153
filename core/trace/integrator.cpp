#include "core/trace/integrator.h"

#include <algorithm>

#include "core/base/deep_threads.h"
#include "core/trace/indirect_light.h"

namespace lentray::core {
namespace {

/// The one at the pixel's centre (random_key.h).
bool is_first_sample(Pixel pixel, std::uint64_t key) {
  return key == std::bit_cast<std::uint64_t>(pixel);
}

}  // namespace

Integrator::Integrator(ThreadContext& context, ShadowTester& shadows)
    : Integrator(context, shadows, PathRules{context.scene.settings().adc_bailout}) {}

Integrator::Integrator(ThreadContext& context, ShadowTester& shadows, const PathRules& rules)
    : m_context(context), m_stepper(context, shadows, rules) {}

[[gnu::always_inline]] inline Radiance Integrator::leave_ray(const RayState& state,
                                                             const RayRecord& record) {
  Radiance seen = record.onward.empty() && record.parts.empty()
                      ? record.own
                      : record.gather([this](const OnwardRay& r) { return follow(r.state); });
  m_stepper.arrive(state, record, seen);
  --m_depth;
  return seen;
}

[[gnu::always_inline]] inline RayRecord& Integrator::enter_ray() {
  if (m_depth == m_records.size()) m_records.push_back(std::make_unique<RayRecord>());
  return *m_records[m_depth++];
}

/// Clear surfaces do not count as levels, so that there may be any number of them.
[[gnu::always_inline]] inline bool Integrator::is_too_deep() {
  if (m_depth < kMostRays) [[likely]]
    return false;
  ++m_context.counters.cut_rays;
  return true;
}

[[gnu::always_inline]] inline Radiance Integrator::follow_here(const RayState& state) {
  if (m_stepper.is_cut(state) || is_too_deep()) return {};
  RayRecord& record = enter_ray();
  m_stepper.step(state, record);
  return leave_ray(state, record);
}

Radiance Integrator::follow(const RayState& state) { return follow_here(state); }

Radiance Integrator::follow_from(const RayState& state, std::size_t depth) {
  const std::size_t before = m_depth;
  while (m_records.size() < depth) m_records.push_back(std::make_unique<RayRecord>());
  m_depth = depth;
  const Radiance seen = follow(state);
  m_depth = before;
  return seen;
}

[[gnu::always_inline]] inline RayState Integrator::begin(const Ray& ray, Pixel pixel,
                                                         std::uint64_t key) {
  m_context.interiors.forget_if_large();
  if (m_context.indirect) m_context.indirect->begin(pixel, is_first_sample(pixel, key), key);
  return m_stepper.begin(ray, pixel, key);
}

Radiance Integrator::trace(const Ray& ray, Pixel pixel, std::uint64_t key) {
  return follow_here(begin(ray, pixel, key));
}

Radiance Integrator::trace_met(const Ray& ray, Pixel pixel, std::uint64_t key, const Hit* hit) {
  const RayState state = begin(ray, pixel, key);
  if (m_stepper.is_cut(state) || is_too_deep()) return {};
  RayRecord& record = enter_ray();
  m_stepper.see(state, hit, record);
  return leave_ray(state, record);
}

GatheredRay Integrator::gather(const GatherRay& from) {
  GatheredRay seen;
  if (is_too_deep()) return seen;
  RayState state{from.ray, from.key};
  state.weight = from.weight;
  state.level = from.level;
  state.kind = RayKind::kGather;
  state.scattered = from.scattered;
  Hit hit;
  const bool met = m_stepper.meet(state, hit);
  const Scene& scene = m_context.scene;
  if (met) {
    seen.importance = static_cast<float>(scene.pass_flags(hit.leaf->attributes()).importance);
    seen.distance = hit.t;
  } else if (const auto& radiosity = scene.settings().radiosity) {
    seen.importance = static_cast<float>(radiosity->default_importance);
  }
  if (seen.importance < from.least_importance) return seen;
  // However deep the gathers are, each sees as far as its own ray.
  const int most = m_stepper.most_levels();
  m_stepper.set_most_levels(std::max(most, from.level + 1));
  RayRecord& record = enter_ray();
  m_stepper.see(state, met ? &hit : nullptr, record);
  seen.light = leave_ray(state, record).rgb;
  m_stepper.set_most_levels(most);
  return seen;
}

}  // namespace lentray::core
