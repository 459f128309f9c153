// What a shadow cache remembers, under the keys of a policy (cache_policy.h), and how it is asked:
// an entry is put to the plain tester's own test (same distances, same clipping, same CSG), so
// that its answer is the full search's. One a thread.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>

#include "core/render/plain_shadow_tester.h"
#include "shadow/cache_policy.h"

namespace lentray::shadow {

template <class Policy>
class CacheTable {
 public:
  explicit CacheTable(const Policy& policy) : m_policy(policy) {}

  /// What blocks the query alone, of the entries worth a look; null: none does. Probes are counted.
  const core::Object* blocker(const core::ShadowQuery& query, const core::PlainShadowTester& plain,
                              core::ShadowCounts& counts) {
    const core::Object* found = nullptr;
    probe(query, [&](const core::Object& entry) {
      ++counts.probes;
      const bool blocks = plain.blocks(entry, query);
      ++(blocks ? counts.hits : counts.misses);
      if (blocks) found = &entry;
      return blocks;
    });
    return found;
  }

  /// Calls ask(entry) for the entries worth a look until it returns true; whether it did.
  template <class Ask>
  bool probe(const core::ShadowQuery& query, Ask&& ask) {
    if (!m_entries) m_entries = zeroed(m_policy.slots());
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
      if (!ask(*entry)) continue;
      if constexpr (Policy::kProbes > 1) remember(query, entry);
      return true;
    }
    return false;
  }

  /// Only after a probe.
  void remember(const core::ShadowQuery& query, const core::Object* blocker) {
    const Keys homes = m_policy.homes(query);
    for (std::size_t i = 0; i < homes.count; ++i) m_entries[homes.slot[i]] = blocker;
  }

 private:
  /// Memory that the system gives as zeros costs nothing where it is not used.
  struct Free {
    void operator()(const core::Object** entries) const { std::free(entries); }
  };
  using Entries = std::unique_ptr<const core::Object*[], Free>;
  static Entries zeroed(std::size_t count) {
    Entries entries(static_cast<const core::Object**>(
        std::calloc(std::max<std::size_t>(count, 1), sizeof(const core::Object*))));
    if (!entries) throw std::bad_alloc();
    return entries;
  }

  const Policy m_policy;
  Entries m_entries;  ///< null until it is asked
};

}  // namespace lentray::shadow
