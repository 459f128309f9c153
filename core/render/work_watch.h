// Tells a progress bar, several times a second, how far a frame is and how long it will take. It
// begins when the frame has lasted a second, and spends less than a hundredth of the work on probes.
// A thread of its own, from when it is made until it goes away, with a stack as deep as the frame's.
#pragma once

#include <condition_variable>
#include <mutex>
#include <thread>

#include "core/render/film.h"
#include "core/render/frame.h"
#include "core/render/work_cells.h"

namespace lentray::core {

class WorkWatch {
 public:
  /// All that is referred to outlives it; the film is copied.
  WorkWatch(const Scene& scene, const RaySource& camera, const ShadowTesterFactory& shadows,
            const FrameOptions& options, FilmSetup film, std::uint32_t band_height,
            Progress& progress);
  ~WorkWatch();

  /// Threads report to them.
  WorkCells& cells() { return m_cells; }
  const FilmSetup& film() const { return m_film; }

 private:
  /// False once the frame has ended.
  bool wait(std::stop_token& stop, double seconds);
  void run(std::stop_token stop);
  void follow(std::stop_token& stop);

  const Scene& m_scene;
  const RaySource& m_camera;
  const ShadowTesterFactory& m_shadows;
  const FrameOptions& m_options;
  const FilmSetup m_film;
  const std::uint32_t m_band_height;
  Progress& m_progress;
  WorkCells m_cells;
  std::mutex m_mutex;
  std::condition_variable_any m_ended;
  std::jthread m_thread;  // last: it uses the others
};

}  // namespace lentray::core
