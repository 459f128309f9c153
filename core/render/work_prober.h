// Traces samples of a picture ahead of the picture, to see what they take. It has a tracer and
// counts of its own, and traces rays that the picture traces too: nothing that is rendered or
// counted changes. One thread.
#pragma once

#include <memory>

#include "core/base/counters.h"
#include "core/render/film.h"
#include "core/render/frame.h"
#include "core/render/work_estimate.h"
#include "core/trace/indirect_light.h"
#include "core/trace/thread_context.h"

namespace lentray::core {

class WorkProber {
 public:
  /// All that is referred to outlives it.
  WorkProber(const Scene& scene, const RaySource& camera, const ShadowTesterFactory& shadows,
             const FrameOptions& options, const FilmSetup& film, const WorkCells& cells);
  /// Probes the next place where the picture is not traced yet and tells the estimate. The places
  /// are spread evenly, however many there are. False: none was found.
  bool probe(WorkEstimate& estimate);
  double seconds() const { return m_seconds; }  ///< CPU time spent so far
  int probes() const { return m_probes; }

 private:
  /// Sample 0 of a pixel, as the film takes it.
  Compared sample(std::uint32_t column, std::uint32_t row);
  void probe(const Pixel& pixel, std::size_t cell, WorkEstimate& estimate);

  const FilmSetup& m_film;
  const PixelRegion m_region;
  const WorkCells& m_cells;
  ThreadContext m_context;
  const std::unique_ptr<ShadowTester> m_tester;
  const std::unique_ptr<IndirectLight> m_indirect;  ///< null: there is none
  const std::unique_ptr<Integrator> m_integrator;
  Sampler m_sampler;
  double m_clock = 0.0;                 ///< what reading the clock twice takes
  double m_across = 0.0, m_down = 0.0;  ///< the next place, 0..1 of the region
  double m_seconds = 0.0;
  int m_probes = 0;
};

}  // namespace lentray::core
