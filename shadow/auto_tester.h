// Shadow_Cache=auto: a light with a light buffer needs no cache, since the first object of the buffer's
// cell nearly always is the occluder; every other light has the cache `neighbourhood`, unless there are
// many lights (core/scene/many_lights.h).
// On scenes without light buffers the neighbourhood costs a percent at most where it brings nothing
// (tests/bench/auto_cost.py); where searches are dear it saves most of them.
// The picture is the plain tester's, as with every cache. One a thread.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "core/scene/many_lights.h"
#include "core/trace/plain_shadow_tester.h"
#include "core/trace/thread_context.h"
#include "shadow/cached_tester.h"
#include "shadow/neighbourhood.h"

namespace lentray::shadow {

class AutoTester final : public core::ShadowTester {
 public:
  static constexpr std::string_view kName = "auto";
  explicit AutoTester(core::ThreadContext& context)
      : m_plain(context, true), m_has_cache(who_has_caches(context.scene)),
        m_cache(std::ranges::count(m_has_cache, 1) == 0 ? 0 : m_has_cache.size()),
        m_asker(m_cache, m_plain) {}

  core::Visibility visibility(const core::ShadowQuery& query) override {
    core::ShadowCounts& counts = m_plain.context().counters.lights[query.light];
    if (!m_has_cache[query.light]) return m_plain.visibility(query);
    ++counts.rays;
    ++counts.cached;
    return m_asker.visibility(query, counts);
  }
  core::PlainShadowTester* plain() override {
    return std::ranges::count(m_has_cache, 1) == 0 ? &m_plain : nullptr;
  }

 private:
  static std::vector<std::uint8_t> who_has_caches(const core::Scene& scene) {
    std::vector<std::uint8_t> out(scene.lights().size());
    if (core::has_many_lights(scene)) return out;
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = scene.light_buffer(i) ? 0 : 1;
    return out;
  }

  core::PlainShadowTester m_plain;
  std::vector<std::uint8_t> m_has_cache;  ///< one a light
  Neighbourhood m_cache;
  Asker<Neighbourhood> m_asker;
};

}  // namespace lentray::shadow
