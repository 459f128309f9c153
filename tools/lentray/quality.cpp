#include "tools/lentray/quality.h"

namespace lentray::tool {
namespace {

class NoShadows final : public core::ShadowTester {
 public:
  core::Visibility visibility(const core::ShadowQuery&) override { return {}; }
};

class NoShadowsFactory final : public core::ShadowTesterFactory {
 public:
  std::unique_ptr<core::ShadowTester> make(const core::ShadowContext&) const override {
    return std::make_unique<NoShadows>();
  }
};

}  // namespace

void reduce(core::SceneParts& parts, int quality) {
  if (quality < 6) parts.settings.max_trace_level = 1;
  if (quality < 5) {
    for (core::Light& light : parts.lights) light.has_area = false;
  }
}

std::unique_ptr<core::ShadowTesterFactory> shadowless_tester(int quality) {
  if (quality >= 4) return nullptr;
  return std::make_unique<NoShadowsFactory>();
}

std::string missing_quality(int quality) {
  if (quality == 6 || quality == 7) {
    return "+Q" + std::to_string(quality) + ": reflections are not left out yet";
  }
  if (quality >= 2) return {};
  return "+Q" + std::to_string(quality) +
         ": colours without any shading are not there yet; rendered as +Q2";
}

}  // namespace lentray::tool
