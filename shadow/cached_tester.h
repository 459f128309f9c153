// A shadow tester that first asks what blocked the light before. Decorates the plain tester and
// never gives another answer: an entry is put to the plain tester's own test (same distances,
// same clipping, same CSG), and only objects that stop all light on their own are remembered.
// One a thread, with entries of its own; nothing is shared.
#pragma once

#include <vector>

#include "core/render/plain_shadow_tester.h"
#include "shadow/cache_policy.h"

namespace lentray::shadow {

template <class Policy>
class CachedTester final : public core::ShadowTester {
 public:
  CachedTester(const core::ShadowContext& context, std::size_t lights)
      : m_plain(context), m_policy(lights), m_entries(m_policy.slots(), nullptr) {}

  core::Visibility visibility(const core::ShadowQuery& query) override {
    core::ShadowCounts& counts = m_plain.context().counters->lights[query.light];
    ++counts.rays;
    const Keys keys = m_policy.keys(query);
    for (std::size_t i = 0; i < keys.count; ++i) {
      const core::Object* entry = m_entries[keys.slot[i]];
      if (!entry) continue;
      ++counts.probes;
      if (m_plain.blocks(*entry, query)) {
        ++counts.hits;
        ++counts.blocked;
        return {core::Rgb(0.0f), entry};
      }
      ++counts.misses;
      break;
    }
    const core::Visibility seen = m_plain.search(query);
    if (seen.blocker) {
      ++counts.blocked;
      m_entries[m_policy.home(query)] = seen.blocker;  // a miss leaves the entry as it is
    }
    return seen;
  }

 private:
  core::PlainShadowTester m_plain;
  Policy m_policy;
  std::vector<const core::Object*> m_entries;
};

}  // namespace lentray::shadow
