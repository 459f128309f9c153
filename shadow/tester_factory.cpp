#include "shadow/tester_factory.h"

#include <stdexcept>

#include "core/render/plain_shadow_tester.h"
#include "core/scene/scene.h"
#include "shadow/auto_tester.h"
#include "shadow/cached_tester.h"
#include "shadow/direction_policy.h"
#include "shadow/names.h"

namespace lentray::shadow {
namespace {

template <class Policy>
class CachedTesterFactory final : public core::ShadowTesterFactory {
 public:
  std::unique_ptr<core::ShadowTester> make(const core::ShadowContext& context) const override {
    return std::make_unique<CachedTester<Policy>>(context, Policy(*context.scene));
  }
};

class AutoTesterFactory final : public core::ShadowTesterFactory {
 public:
  std::unique_ptr<core::ShadowTester> make(const core::ShadowContext& context) const override {
    return std::make_unique<AutoTester>(context);
  }
};

struct Entry {
  std::string_view name;
  std::unique_ptr<core::ShadowTesterFactory> (*make)();
};

template <class Factory>
std::unique_ptr<core::ShadowTesterFactory> make_one() {
  return std::make_unique<Factory>();
}

constexpr Entry kTesters[] = {
    {AutoTester::kName, make_one<AutoTesterFactory>},
    {"off", make_one<core::PlainShadowTesterFactory>},
    {LastPolicy::kName, make_one<CachedTesterFactory<LastPolicy>>},
    {DepthPolicy::kName, make_one<CachedTesterFactory<DepthPolicy>>},
    {TreePolicy::kName, make_one<CachedTesterFactory<TreePolicy>>},
    {NeighbourhoodPolicy::kName, make_one<CachedTesterFactory<NeighbourhoodPolicy>>},
    {DirectionPolicy::kName, make_one<CachedTesterFactory<DirectionPolicy>>},
};

std::vector<std::string_view> names_of_testers() {
  std::vector<std::string_view> names;
  for (const Entry& entry : kTesters) names.push_back(entry.name);
  return names;
}

}  // namespace

const std::vector<std::string_view>& tester_names() {
  static const std::vector<std::string_view> kNames = names_of_testers();
  return kNames;
}

std::unique_ptr<core::ShadowTesterFactory> make_tester_factory(std::string_view name) {
  for (const Entry& entry : kTesters) {
    if (same_name(entry.name, name)) return entry.make();
  }
  throw std::invalid_argument(unknown_name("shadow cache", name, tester_names()));
}

}  // namespace lentray::shadow
