// The threads of a radiosity pass: each traces camera rays and rays of gathers, and notes what their
// surfaces ask. World space.
// Errors: PassCancelled. The leader of the pass calls.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/pass/pass_run.h"
#include "core/trace/integrator.h"
#include "core/trace/query_recorder.h"
#include "core/trace/radiosity_light.h"
#include "core/trace/thread_context.h"

namespace lentray::core {

/// A camera ray of the pass.
struct PassRay {
  Ray ray;
  Pixel pixel;
  bool shows = false;  ///< false: there is none
};

class GatherThreads final : public GatherTeam {
 public:
  /// `light`: what earlier passes left. All outlive it.
  GatherThreads(const Scene& scene, const Illumination& light, const ShadowTesterFactory& shadows,
                PassRun& run)
      : m_scene(scene), m_light(light), m_shadows(shadows), m_run(run), m_threads(run.threads()) {}
  void trace(std::span<const GatherRay> rays, const SampleLookup* asked,
             std::span<GatherRecord> records) override;
  bool recall(std::string& record) override { return m_run.recall(record); }
  void keep(std::string_view record) override { m_run.keep(record); }
  /// Traces the camera rays and records the queries for indirect light that their surfaces make. The light along
  /// the rays is not used.
  void look(std::span<const PassRay> rays, const SampleLookup& asked,
            std::span<GatherRecord> records);
  /// Adds the rays that were traced to the pass's numbers.
  void count_rays();

 private:
  struct Thread {
    Thread(const Scene& scene, const Illumination& light, const ShadowTesterFactory& factory);
    ThreadContext context;
    std::unique_ptr<ShadowTester> shadows;
    Integrator camera;
    Integrator gatherer;
    QueryRecorder recorder;
  };
  /// That number's, made on its own thread.
  Thread& thread(unsigned number);
  /// Who answers alone finds samples when it is time: what is found early may have to be found again.
  const SampleLookup* early(const SampleLookup* lookup) const {
    return m_run.threads() > 1 ? lookup : nullptr;
  }

  const Scene& m_scene;
  const Illumination& m_light;
  const ShadowTesterFactory& m_shadows;
  PassRun& m_run;
  std::vector<std::unique_ptr<Thread>> m_threads;
};

}  // namespace lentray::core
