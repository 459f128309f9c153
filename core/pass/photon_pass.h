// Shoots the photons of a scene, before anything is seen of it: unit after unit, ring after ring. World
// space. The photons and their order are stock's with one thread; those in media lie at random elsewhere by
// as much as `jitter` says.
// Source: reference manual 3.7, "Photons"; core/photon/rings.h.
#pragma once

#include <cstdint>
#include <memory>

#include "core/pass/pass.h"
#include "core/photon/photon_maps.h"
#include "core/photon/rings.h"

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

  /// Of a scene with photons, which outlives it. `most`: kept at most.
  explicit PhotonPass(const Scene& scene, std::uint64_t most = kMostPhotons)
      : m_scene(scene), m_most(most) {}
  std::string name() const override { return "photons"; }
  double work() const override;
  void run(PassRun& run) override;
  const PhotonReport& report() const { return m_report; }
  /// In the order in which they came to rest; may be taken away.
  PhotonMaps& photons() { return m_photons; }

 private:
  class Shooting;
  const Scene& m_scene;
  const std::uint64_t m_most;
  PhotonReport m_report;
  PhotonMaps m_photons;
};

}  // namespace lentray::core
