#include "shadow/tester_factory.h"

#include <stdexcept>

#include "core/trace/plain_shadow_tester.h"
#include "shadow/auto_tester.h"
#include "shadow/cached_tester.h"
#include "shadow/cascade.h"
#include "shadow/direction_policy.h"
#include "shadow/names.h"

namespace lentray::shadow {
namespace {

struct TesterEntry {
  std::string_view name;
  std::unique_ptr<core::ShadowTesterFactory> (*make)();
};

template <class Tester>
std::unique_ptr<core::ShadowTesterFactory> make_testers() {
  return std::make_unique<core::ShadowTestersOf<Tester>>();
}

template <class Cache>
constexpr TesterEntry entry_of() {
  return {Cache::kName, make_testers<CachedTester<Cache>>};
}

constexpr TesterEntry kTesters[] = {
    {AutoTester::kName, make_testers<AutoTester>},
    {"off", make_testers<core::PlainShadowTester>},
    entry_of<CacheTable<LastPolicy>>(),
    entry_of<CacheTable<DepthPolicy>>(),
    entry_of<CacheTable<TreePolicy>>(),
    entry_of<Neighbourhood>(),
    entry_of<CacheTable<DirectionPolicy>>(),
    entry_of<Cascade>(),
};

}  // namespace

const std::vector<std::string_view>& tester_names() {
  static const std::vector<std::string_view> kNames = names_of(kTesters);
  return kNames;
}

std::unique_ptr<core::ShadowTesterFactory> make_tester_factory(std::string_view name) {
  for (const TesterEntry& entry : kTesters) {
    if (same_name(entry.name, name)) return entry.make();
  }
  throw std::invalid_argument(unknown_name("shadow cache", name, tester_names()));
}

}  // namespace lentray::shadow
