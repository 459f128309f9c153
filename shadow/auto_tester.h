// Shadow_Cache=auto: a light with a light buffer needs no cache, since the first object of the buffer's
// cell nearly always is the occluder; every other light has the cache `neighbourhood`.
// On scenes without light buffers the neighbourhood costs a percent at most where it brings nothing
// (tests/bench/auto_cost.py); where searches are dear it saves most of them.
// The picture is the plain tester's, as with every cache. One a thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "core/trace/plain_shadow_tester.h"
#include "core/trace/thread_context.h"
#include "shadow/cached_tester.h"
#include "shadow/neighbourhood.h"

namespace lentray::shadow {

class AutoTester final : public core::ShadowTester {
 public:
  static constexpr std::string_view kName = "auto";
  explicit AutoTester(core::ThreadContext& context)
      : m_plain(context, true), m_cache(context.scene), m_asker(m_cache, m_plain) {
    for (std::size_t i = 0; i < context.scene.lights().size(); ++i) {
      m_has_cache.push_back(context.scene.light_buffer(i) ? 0 : 1);
    }
  }

  core::Visibility visibility(const core::ShadowQuery& query) override {
    core::ShadowCounts& counts = m_plain.context().counters.lights[query.light];
    if (!m_has_cache[query.light]) return m_plain.visibility(query);
    ++counts.rays;
    ++counts.cached;
    return m_asker.visibility(query, counts);
  }

 private:
  core::PlainShadowTester m_plain;
  Neighbourhood m_cache;
  Asker<Neighbourhood> m_asker;
  std::vector<std::uint8_t> m_has_cache;  ///< one a light
};

}  // namespace lentray::shadow
