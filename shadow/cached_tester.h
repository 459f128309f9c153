// A shadow tester that first asks what blocked the light before. Decorates the plain tester and
// never gives another answer: an entry is put to the plain tester's own test, and only objects that
// stop all light on their own are remembered. One a thread, with entries of its own; nothing is
// shared.
#pragma once

#include "core/render/plain_shadow_tester.h"
#include "shadow/cache_table.h"

namespace lentray::shadow {

/// The table's answer, else the full search's, which the table then knows. The ray is counted
/// already.
template <class Policy>
core::Visibility visibility_by(CacheTable<Policy>& table, const core::ShadowQuery& query,
                               core::PlainShadowTester& plain, core::ShadowCounts& counts) {
  if (const core::Object* entry = table.blocker(query, plain, counts)) {
    ++counts.blocked;
    return {core::Rgb(0.0f), entry};
  }
  const core::Visibility seen = plain.search(query);
  if (seen.blocker) {
    ++counts.blocked;
    table.remember(query, seen.blocker);  // a miss leaves the entries as they are
  }
  return seen;
}

template <class Policy>
class CachedTester final : public core::ShadowTester {
 public:
  CachedTester(const core::ShadowContext& context, const Policy& policy)
      : m_plain(context), m_table(policy) {}

  core::Visibility visibility(const core::ShadowQuery& query) override {
    core::ShadowCounts& counts = m_plain.context().counters->lights[query.light];
    ++counts.rays;
    return visibility_by(m_table, query, m_plain, counts);
  }

 private:
  core::PlainShadowTester m_plain;
  CacheTable<Policy> m_table;
};

}  // namespace lentray::shadow
