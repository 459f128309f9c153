#include "core/pass/gather_threads.h"

#include "core/scene/scene.h"
#include "core/trace/path_rules.h"

namespace lentray::core {
namespace {

/// Camera rays need no light of their own: all they are for is where they ask for indirect light.
PathRules unlit(const Scene& scene) {
  PathRules rules{scene.settings().adc_bailout};
  rules.lights = false;
  return rules;
}

}  // namespace

GatherThreads::Thread::Thread(const Scene& scene, const Illumination& light,
                              const ShadowTesterFactory& factory)
    : context(scene, false, &light), shadows(factory.make(context)),
      camera(context, *shadows, unlit(scene)), gatherer(make_gatherer(context, *shadows)) {
  context.indirect = &recorder;
}

GatherThreads::Thread& GatherThreads::thread(unsigned number) {
  std::unique_ptr<Thread>& thread = m_threads[number];
  if (!thread) thread = std::make_unique<Thread>(m_scene, m_light, m_shadows);
  return *thread;
}

void GatherThreads::trace(std::span<const GatherRay> rays, const SampleLookup* asked,
                          std::span<GatherRecord> records) {
  m_run.each(rays.size(), [&](unsigned number, std::size_t ray) {
    Thread& own = thread(number);
    own.recorder.record_to(records[ray], asked != nullptr, early(asked));
    records[ray].seen = own.gatherer.gather(rays[ray]);
  });
}

void GatherThreads::look(std::span<const PassRay> rays, const SampleLookup& asked,
                         std::span<GatherRecord> records) {
  m_run.each(rays.size(), [&](unsigned number, std::size_t ray) {
    Thread& own = thread(number);
    own.recorder.record_to(records[ray], true, early(&asked));
    if (rays[ray].shows) own.camera.trace(rays[ray].ray, rays[ray].pixel);
  });
}

void GatherThreads::count_rays() {
  Counters all;
  all.lights.resize(m_scene.lights().size());
  for (const auto& thread : m_threads) {
    if (thread) all.merge(thread->context.counters);
  }
  std::uint64_t shadow_rays = 0;
  for (const ShadowCounts& light : all.lights) shadow_rays += light.rays;
  m_run.count("camera_rays", static_cast<double>(all.camera_rays));
  m_run.count("reflected_rays", static_cast<double>(all.reflected_rays));
  m_run.count("refracted_rays", static_cast<double>(all.refracted_rays));
  m_run.count("shadow_rays", static_cast<double>(shadow_rays));
}

}  // namespace lentray::core
