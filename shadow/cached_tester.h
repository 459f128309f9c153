// A shadow tester that first asks what blocked the light before. Decorates the plain tester and
// never gives another answer: an entry is put to the plain tester's own test, and only objects that
// stop all light on their own are remembered. One a thread, with entries of its own; nothing is
// shared.
#pragma once

#include "core/trace/plain_shadow_tester.h"
#include "core/trace/thread_context.h"
#include "shadow/cache_table.h"

namespace lentray::shadow {

/// Asks a cache, and what the cache does not know searches for. Both must outlive it.
template <class Cache>
class Asker {
 public:
  Asker(Cache& cache, core::PlainShadowTester& plain) : m_cache(cache), m_plain(plain) {}

  /// The cache's answer where it has entries worth a look, else the full search's, which the cache
  /// then knows. The ray is counted already.
  [[gnu::always_inline]] core::Visibility visibility(const core::ShadowQuery& query,
                                                     core::ShadowCounts& counts) {
    const typename Cache::Spot spot = m_cache.spot(query);
    const bool empty = Cache::empty(spot);
    if (!empty) {
      if (const core::Object* entry = ask(spot, query, counts)) return {core::Rgb(0.0f), entry};
    }
    return search(spot, empty, query, counts);
  }

 private:
  [[gnu::always_inline]] const core::Object* ask(const typename Cache::Spot& spot,
                                                 const core::ShadowQuery& query,
                                                 core::ShadowCounts& counts) {
    Tried tried;
    const core::Object* entry = m_cache.probe(query, spot, tried, [&](const core::Object& asked) {
      return m_plain.blocks(asked, query);
    });
    const std::size_t failed = tried.count();
    counts.misses += failed;
    counts.probes += failed;
    if (!entry) return nullptr;
    ++counts.probes;
    ++counts.hits;
    ++counts.blocked;
    m_cache.found(query, spot, entry);
    return entry;
  }

  [[gnu::always_inline]] core::Visibility search(const typename Cache::Spot& spot, bool empty,
                                                 const core::ShadowQuery& query,
                                                 core::ShadowCounts& counts) {
    const core::Visibility seen = m_plain.search(query);
    if (seen.blocker) ++counts.blocked;
    if (seen.blocker || !empty) m_cache.searched(query, spot, seen.blocker);
    return seen;
  }

  Cache& m_cache;
  core::PlainShadowTester& m_plain;
};

template <class Cache>
class CachedTester final : public core::ShadowTester {
 public:
  explicit CachedTester(core::ThreadContext& context)
      : m_plain(context), m_cache(context.scene), m_asker(m_cache, m_plain) {}

  core::Visibility visibility(const core::ShadowQuery& query) override {
    core::ShadowCounts& counts = m_plain.context().counters.lights[query.light];
    ++counts.rays;
    return m_asker.visibility(query, counts);
  }

 private:
  core::PlainShadowTester m_plain;
  Cache m_cache;
  Asker<Cache> m_asker;
};

}  // namespace lentray::shadow
