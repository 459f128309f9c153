#include "core/trace/whitted_integrator.h"

#include <array>
#include <utility>

namespace lentray::core {

template <unsigned kFeatures>
Radiance WhittedIntegrator<kFeatures>::trace(const Ray& ray, Pixel pixel, std::uint64_t key) {
  m_context.interiors.forget_if_large();
  return follow(m_stepper.begin(ray, pixel, key));
}

template <unsigned kFeatures>
Radiance WhittedIntegrator<kFeatures>::follow(const RayState& state) {
  if (m_stepper.is_cut(state)) return {};
  if (m_depth >= m_deepest) {
    ++m_context.counters.cut_rays;
    return {};
  }
  RayRecord& record = enter_ray();
  m_stepper.step(state, record);
  Radiance seen = record.gather([this](const OnwardRay& onward) { return follow(onward.state); });
  m_stepper.arrive(state, record, seen);
  --m_depth;
  return seen;
}

template <unsigned kFeatures>
RayRecord& WhittedIntegrator<kFeatures>::enter_ray() {
  if (m_depth == m_records.size()) {
    m_records.push_back(std::make_unique<RayRecord>());
    // Clear surfaces do not count as levels, so that there may be any number of them. Half of the
    // stack is for steps that take more of it than these.
    const auto here = reinterpret_cast<std::uintptr_t>(__builtin_frame_address(0));
    if (here < m_stack_end) m_deepest = m_depth + 1;
  }
  return *m_records[m_depth++];
}

unsigned path_features(const Needs& needs) {
  unsigned features = 0;
  if (needs.transparency || needs.refraction) features |= kPathTransparency;
  if (needs.reflection) features |= kPathReflection;
  if (needs.layered_textures || needs.textures_by_place || needs.interior_textures) {
    features |= kPathLayers;
  }
  if (needs.area_lights) features |= kPathArea;
  return features;
}

namespace {

using Maker = std::unique_ptr<Integrator> (*)(ThreadContext&, ShadowTester&);

template <unsigned kFeatures>
std::unique_ptr<Integrator> make_one(ThreadContext& context, ShadowTester& shadows) {
  return std::make_unique<WhittedIntegrator<kFeatures>>(context, shadows);
}

template <unsigned... kFeatures>
constexpr std::array<Maker, sizeof...(kFeatures)> all_makers(
    std::integer_sequence<unsigned, kFeatures...>) {
  return {make_one<kFeatures>...};
}

}  // namespace

std::unique_ptr<Integrator> make_whitted_integrator(unsigned features, ThreadContext& context,
                                                    ShadowTester& shadows) {
  static constexpr auto kMakers = all_makers(std::make_integer_sequence<unsigned, kAllPaths>{});
  return kMakers.at(features)(context, shadows);
}

std::unique_ptr<Integrator> Integrator::make(ThreadContext& context, ShadowTester& shadows) {
  return make_whitted_integrator(path_features(context.scene.needs()), context, shadows);
}

}  // namespace lentray::core
