// A shadow tester that first asks what blocked the light before. Decorates the plain tester and
// never gives another answer: an entry is put to the plain tester's own test, and only objects that
// stop all light on their own are remembered. One a thread, with entries of its own; nothing is
// shared.
#pragma once

#include "core/render/plain_shadow_tester.h"
#include "shadow/cache_table.h"

namespace lentray::shadow {

/// The cache's answer where it has entries worth a look, else the full search's, which the cache
/// then knows. `vain` is told of the entries asked in vain.
template <class Cache, class Vain>
[[gnu::noinline]] core::Visibility ask(Cache& cache, const typename Cache::Spot& spot,
                                       const core::ShadowQuery& query,
                                       core::PlainShadowTester& plain,
                                       core::ShadowCounts& counts, Vain vain) {
  Tried tried;
  const core::Object* entry = cache.probe(query, spot, tried, [&](const core::Object& asked) {
    return plain.blocks(asked, query);
  });
  const std::size_t failed = tried.count();
  counts.misses += failed;
  counts.probes += failed;
  vain(tried);
  if (entry) {
    ++counts.probes;
    ++counts.hits;
    ++counts.blocked;
    cache.found(query, spot, entry);
    return {core::Rgb(0.0f), entry};
  }
  const core::Visibility seen = plain.search(query);
  if (seen.blocker) ++counts.blocked;
  cache.searched(query, spot, seen.blocker);
  return seen;
}

/// The full search's, where the cache knows nothing.
template <class Cache>
core::Visibility search_for(Cache& cache, const typename Cache::Spot& spot,
                            const core::ShadowQuery& query, core::PlainShadowTester& plain,
                            core::ShadowCounts& counts) {
  const core::Visibility seen = plain.search(query);
  if (seen.blocker) [[unlikely]] {
    ++counts.blocked;
    cache.searched(query, spot, seen.blocker);
  }
  return seen;
}

struct Unwatched {
  void operator()(const Tried&) const {}
};

/// The ray is counted already.
template <class Cache, class Vain = Unwatched>
core::Visibility visibility_by(Cache& cache, const core::ShadowQuery& query,
                               core::PlainShadowTester& plain, core::ShadowCounts& counts,
                               Vain vain = {}) {
  const auto spot = cache.spot(query);
  if (cache.empty(spot)) return search_for(cache, spot, query, plain, counts);
  return ask(cache, spot, query, plain, counts, vain);
}

template <class Cache>
class CachedTester final : public core::ShadowTester {
 public:
  explicit CachedTester(const core::ShadowContext& context)
      : m_plain(context), m_cache(*context.scene) {}

  core::Visibility visibility(const core::ShadowQuery& query) override {
    core::ShadowCounts& counts = m_plain.context().counters->lights[query.light];
    ++counts.rays;
    return visibility_by(m_cache, query, m_plain, counts);
  }

 private:
  core::PlainShadowTester m_plain;
  Cache m_cache;
};

}  // namespace lentray::shadow
