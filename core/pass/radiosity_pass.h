// Makes the samples of radiosity that a picture is then lit with: level after level of places that lie ever
// closer, at last every pixel, so that the picture itself adds nothing. Pixels of the picture; world space.
// Places come in one order, and so does what is decided at them, whatever the number of threads.
// Source: reference manual 3.7, "Radiosity", "How Radiosity Works"; the order is that of POV-Ray 3.7 with one
// thread (core/irradiance/pretrace.h).
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "core/irradiance/rca_samples.h"
#include "core/pass/pass.h"
#include "core/render/ray_source.h"
#include "core/trace/illumination.h"
#include "core/trace/radiosity_light.h"

namespace lentray::core {

class Scene;

struct RadiosityPassSetup {
  const Scene& scene;  ///< with radiosity
  const RaySource& camera;
  std::uint32_t width = 0, height = 0;  ///< of the picture
  Vec3 eye;                             ///< from which the lengths of reuse are measured
  /// Whether the last level has a place in each pixel; else it has some 250,000.
  bool sees_every_pixel = true;
  /// Samples at most; 0: as the memory allows. More end the pass with NoRoom (core/base/memory_limit.h).
  std::uint64_t most_samples = 0;
  const ShadowTesterFactory& shadows;
};

/// What the levels did.
struct RadiosityReport {
  struct Level {
    std::uint64_t places = 0;
    std::vector<GatherCounts> depths;
  };
  std::vector<Level> levels;
  bool sees_pixels = false;  ///< the last level is that of the pixels
};

class RadiosityPass final : public Pass {
 public:
  /// All that it is given outlives it; `result` gets the samples.
  RadiosityPass(const RadiosityPassSetup& setup, Illumination& result)
      : m_setup(setup), m_result(result) {}
  /// Samples that are there before it begins; those of deeper stores than the scene's are not used.
  void begin_with(std::vector<DepthSample> samples) { m_known = std::move(samples); }
  std::string name() const override { return "radiosity"; }
  double work() const override;
  void run(PassRun& run) override;
  const RadiosityReport& report() const { return m_report; }

 private:
  class Levels;
  const RadiosityPassSetup m_setup;
  Illumination& m_result;
  std::vector<DepthSample> m_known;
  RadiosityReport m_report;
};

}  // namespace lentray::core
