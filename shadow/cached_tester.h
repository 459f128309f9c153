// A shadow tester that first asks what blocked the light before. Decorates the plain tester and
// never gives another answer: an entry is put to the plain tester's own test (same distances,
// same clipping, same CSG), and only objects that stop all light on their own are remembered.
// One a thread, with entries of its own; nothing is shared.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "core/render/plain_shadow_tester.h"
#include "shadow/cache_policy.h"

namespace lentray::shadow {

template <class Policy>
class CachedTester final : public core::ShadowTester {
 public:
  CachedTester(const core::ShadowContext& context, const Policy& policy)
      : m_plain(context), m_policy(policy), m_entries(m_policy.slots(), nullptr) {}

  core::Visibility visibility(const core::ShadowQuery& query) override {
    core::ShadowCounts& counts = m_plain.context().counters->lights[query.light];
    ++counts.rays;
    const Keys keys = m_policy.keys(query);
    std::array<const core::Object*, Policy::kProbes> tried{};
    std::size_t probes = 0;
    for (std::size_t i = 0; i < keys.count && probes < Policy::kProbes; ++i) {
      const core::Object* entry = m_entries[keys.slot[i]];
      if (!entry || std::find(tried.begin(), tried.begin() + probes, entry) !=
                        tried.begin() + probes) {
        continue;
      }
      tried[probes++] = entry;
      ++counts.probes;
      if (m_plain.blocks(*entry, query)) {
        ++counts.hits;
        ++counts.blocked;
        if constexpr (Policy::kProbes > 1) remember(query, entry);
        return {core::Rgb(0.0f), entry};
      }
      ++counts.misses;
    }
    const core::Visibility seen = m_plain.search(query);
    if (seen.blocker) {
      ++counts.blocked;
      remember(query, seen.blocker);  // a miss leaves the entries as they are
    }
    return seen;
  }

 private:
  void remember(const core::ShadowQuery& query, const core::Object* blocker) {
    const Keys homes = m_policy.homes(query);
    for (std::size_t i = 0; i < homes.count; ++i) m_entries[homes.slot[i]] = blocker;
  }

  core::PlainShadowTester m_plain;
  const Policy m_policy;
  std::vector<const core::Object*> m_entries;
};

}  // namespace lentray::shadow
