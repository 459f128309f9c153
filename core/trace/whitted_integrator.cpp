#include "core/trace/whitted_integrator.h"

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

#include "core/trace/indirect_light.h"

namespace lentray::core {
namespace {

/// The one at the pixel's centre (random_key.h).
bool is_first_sample(Pixel pixel, std::uint64_t key) {
  return key == std::bit_cast<std::uint64_t>(pixel);
}

}  // namespace

template <unsigned kFeatures>
[[gnu::always_inline]] inline Radiance WhittedIntegrator<kFeatures>::leave_ray(
    const RayState& state, const RayRecord& record) {
  Radiance seen = RayStepper<kFeatures>::kGoesOn || !record.parts.empty()
                      ? record.gather([this](const OnwardRay& r) { return follow(r.state); })
                      : record.own;
  m_stepper.arrive(state, record, seen);
  --m_depth;
  return seen;
}

template <unsigned kFeatures>
[[gnu::always_inline]] inline RayRecord& WhittedIntegrator<kFeatures>::enter_ray() {
  if (m_depth == m_records.size()) {
    m_records.push_back(std::make_unique<RayRecord>());
    // Clear surfaces do not count as levels, so that there may be any number of them. Half of the
    // stack is for steps that take more of it than these.
    const auto here = reinterpret_cast<std::uintptr_t>(__builtin_frame_address(0));
    if (here < m_stack_end) m_deepest = m_depth + 1;
  }
  return *m_records[m_depth++];
}

template <unsigned kFeatures>
[[gnu::always_inline]] inline Radiance WhittedIntegrator<kFeatures>::follow_here(
    const RayState& state) {
  if (m_stepper.is_cut(state)) return {};
  if (m_depth >= m_deepest) {
    ++m_context.counters.cut_rays;
    return {};
  }
  RayRecord& record = enter_ray();
  m_stepper.step(state, record);
  return leave_ray(state, record);
}

template <unsigned kFeatures>
Radiance WhittedIntegrator<kFeatures>::follow(const RayState& state) {
  return follow_here(state);
}

template <unsigned kFeatures>
Radiance WhittedIntegrator<kFeatures>::trace(const Ray& ray, Pixel pixel, std::uint64_t key) {
  m_context.interiors.forget_if_large();
  if (m_context.indirect) m_context.indirect->begin(pixel, is_first_sample(pixel, key), key);
  return follow_here(m_stepper.begin(ray, pixel, key));
}

template <unsigned kFeatures>
GatheredRay WhittedIntegrator<kFeatures>::gather(const GatherRay& from) {
  GatheredRay seen;
  if (m_depth >= m_deepest) {
    ++m_context.counters.cut_rays;
    return seen;
  }
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

unsigned path_features(const Needs& needs) {
  unsigned features = 0;
  if (needs.transparency || needs.refraction || needs.subsurface) features |= kPathTransparency;
  if (needs.reflection) features |= kPathReflection;
  if (needs.layered_textures || needs.textures_by_place || needs.interior_textures) {
    features |= kPathLayers;
  }
  if (needs.area_lights) features |= kPathArea;
  return features;
}

namespace {

using Maker = std::unique_ptr<Integrator> (*)(ThreadContext&, ShadowTester&, const PathRules&);

template <unsigned kFeatures>
std::unique_ptr<Integrator> make_one(ThreadContext& context, ShadowTester& shadows,
                                     const PathRules& rules) {
  return std::make_unique<WhittedIntegrator<kFeatures>>(context, shadows, rules);
}

template <unsigned... kFeatures>
constexpr std::array<Maker, sizeof...(kFeatures)> all_makers(
    std::integer_sequence<unsigned, kFeatures...>) {
  return {make_one<kFeatures>...};
}

}  // namespace

std::unique_ptr<Integrator> make_whitted_integrator(unsigned features, ThreadContext& context,
                                                    ShadowTester& shadows, const PathRules& rules) {
  static constexpr auto kMakers = all_makers(std::make_integer_sequence<unsigned, kAllPaths>{});
  return kMakers.at(features)(context, shadows, rules);
}

std::unique_ptr<Integrator> Integrator::make(ThreadContext& context, ShadowTester& shadows) {
  return make(context, shadows, PathRules{context.scene.settings().adc_bailout});
}

std::unique_ptr<Integrator> Integrator::make(ThreadContext& context, ShadowTester& shadows,
                                             const PathRules& rules) {
  unsigned features = path_features(context.scene.needs());
  if (!rules.area_lights) features &= ~static_cast<unsigned>(kPathArea);
  return make_whitted_integrator(features, context, shadows, rules);
}

}  // namespace lentray::core
