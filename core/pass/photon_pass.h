// Shoots the photons of a scene, before anything is seen of it: unit after unit, ring after ring. World
// space. Photons come in one order, whatever the number of threads. Those in media are moved at random by as much
// as `jitter` says.
// Source: reference manual 3.7, "Photons"; photons and order are those of POV-Ray 3.7 with one thread
// (core/photon/rings.h).
#pragma once

#include <cstdint>
#include <string>

#include "core/pass/pass.h"
#include "core/trace/illumination.h"

namespace lentray::core {

class Scene;

/// What the pass did.
struct PhotonReport {
  std::uint64_t units = 0, shot = 0, surface = 0, media = 0;
  bool is_full = false;  ///< kMostPhotons lay there before all were shot
};

class PhotonPass final : public Pass {
 public:
  /// At most so many photons are kept.
  static constexpr std::uint64_t kMostPhotons = 200'000'000;

  /// Of a scene with photons, which outlives it as `result` does, which gets their map. `most`: kept at most.
  PhotonPass(const Scene& scene, Illumination& result, std::uint64_t most = kMostPhotons)
      : m_scene(scene), m_result(result), m_most(most) {}
  std::string name() const override { return "photons"; }
  double work() const override;
  void run(PassRun& run) override;
  const PhotonReport& report() const { return m_report; }

 private:
  class Shooting;
  const Scene& m_scene;
  Illumination& m_result;
  const std::uint64_t m_most;
  PhotonReport m_report;
};

}  // namespace lentray::core
