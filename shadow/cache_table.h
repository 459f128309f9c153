// What a shadow cache remembers, under the keys of a policy (cache_policy.h), and how it is asked:
// an entry is put to the plain tester's own test (same distances, same clipping, same CSG), so
// that its answer is the full search's. One a thread.
#pragma once

#include <sys/mman.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <new>

#include "core/trace/plain_shadow_tester.h"
#include "shadow/cache_policy.h"

namespace lentray::shadow {

/// Objects that were asked already, and did not block the ray.
class Tried {
 public:
  bool has(const core::Object* object) const {
    for (std::size_t i = 0; i < m_count; ++i) {
      if (m_objects[i] == object) return true;
    }
    return false;
  }
  void add(const core::Object* object) { m_objects[m_count++] = object; }
  std::size_t count() const { return m_count; }

 private:
  std::array<const core::Object*, 8> m_objects;
  std::size_t m_count = 0;
};

/// Asks entry_at(0) to entry_at(count - 1), those that are there and were not tried yet, until
/// one blocks (that one is returned) or so many were tried in all.
template <class Entry, class Ask>
[[gnu::always_inline]] inline const core::Object* ask_in_turn(Entry&& entry_at, std::size_t count,
                                                              Tried& tried, std::size_t most,
                                                              Ask&& ask) {
  for (std::size_t i = 0; i < count; ++i) {
    const core::Object* entry = entry_at(i);
    if (!entry || tried.has(entry)) continue;
    if (ask(*entry)) return entry;
    tried.add(entry);
    if (tried.count() == most) break;
  }
  return nullptr;
}

struct FreeEntries {
  void* mapped = nullptr;
  std::size_t bytes = 0;
  void operator()(const core::Object**) const { ::munmap(mapped, bytes); }
};
using Entries = std::unique_ptr<const core::Object*[], FreeEntries>;
/// Nulls, straight from the system: what it gives as zeros costs nothing where it is not used, while
/// calloc() must clear memory that was in use before. Large tables are asked all over: they lie on the
/// system's large pages where it has them, as hundreds of small ones take longer to get than a small
/// picture's rays gain.
inline Entries zeroed_entries(std::size_t count) {
  constexpr std::size_t kLargePage = 2 * 1024 * 1024;
  const std::size_t needed = std::max<std::size_t>(count, 1) * sizeof(const core::Object*);
  const bool large = needed >= kLargePage;
  const std::size_t bytes = large ? needed + kLargePage : needed;
  void* const mapped =
      ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (mapped == MAP_FAILED) throw std::bad_alloc();
  void* begin = mapped;
  if (large) {
    std::size_t space = bytes;
    std::align(kLargePage, needed, begin, space);
    ::madvise(begin, needed, MADV_HUGEPAGE);  // refused where there are none: no harm
  }
  return Entries(static_cast<const core::Object**>(begin), FreeEntries{mapped, bytes});
}

/// One policy's table as a cache. A cache has
///   explicit Cache(const core::Scene&);
///   Spot spot(query);                    where it looks, as it likes
///   bool empty(spot);                    nothing is worth a probe; the answer comes cheap
///   probe(query, spot, tried, ask);      calls ask(entry) for the entries worth a look, but for
///                                        those tried, until it returns true: that entry, or null
///   found(query, spot, blocker);         a probe's hit
///   searched(query, spot, blocker);      what a search found; null: nothing opaque. Need not be
///                                        told of null where the spot was empty
template <class Policy>
class CacheTable {
 public:
  static constexpr std::string_view kName = Policy::kName;
  explicit CacheTable(const core::Scene& scene)
      : m_policy(scene), m_entries(zeroed_entries(m_policy.slots())) {}

  struct Spot {};
  static Spot spot(const core::ShadowQuery&) { return {}; }
  static bool empty(const Spot&) { return false; }
  template <class Ask>
  const core::Object* probe(const core::ShadowQuery& query, const Spot&, Tried& tried, Ask&& ask) {
    const auto keys = m_policy.keys(query);
    return ask_in_turn([&](std::size_t i) { return m_entries[keys[i]]; }, keys.size(), tried,
                       tried.count() + Policy::kProbes, ask);
  }
  void found(const core::ShadowQuery& query, const Spot& spot, const core::Object* blocker) {
    if constexpr (Policy::kProbes > 1) searched(query, spot, blocker);
  }
  void searched(const core::ShadowQuery& query, const Spot&, const core::Object* blocker) {
    if (!blocker) return;
    for (const std::size_t home : m_policy.homes(query)) m_entries[home] = blocker;
  }

 private:
  const Policy m_policy;
  const Entries m_entries;
};

}  // namespace lentray::shadow
