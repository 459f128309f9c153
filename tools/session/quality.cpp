#include "tools/session/quality.h"

namespace lentray::tool {
namespace {

class NoShadows final : public core::ShadowTester {
 public:
  core::Visibility visibility(const core::ShadowQuery&) override { return {}; }
};

class NoShadowsFactory final : public core::ShadowTesterFactory {
 public:
  std::unique_ptr<core::ShadowTester> make(core::ThreadContext&) const override {
    return std::make_unique<NoShadows>();
  }
};

}  // namespace

void reduce(core::SceneParts& parts, int quality) {
  if (quality < 8) parts.settings.mirror_images = false;
  if (quality < 6) parts.settings.max_trace_level = 1;
  if (quality < 5) {
    for (core::Light& light : parts.lights) light.has_area = false;
  }
}

std::unique_ptr<core::ShadowTesterFactory> shadowless_tester(int quality) {
  if (quality >= 4) return nullptr;
  return std::make_unique<NoShadowsFactory>();
}

}  // namespace lentray::tool
