// The light that photons bring to a place: a map of them, and how many of them are gathered how far about a
// point. World space. Made once, then const: many threads gather.
// Source: reference manual 3.7, "Photons", "global_settings"; numbers that it leaves open replay stock's
// pictures (tests/image/photons_test.cpp).
#pragma once

#include <memory>

#include "core/photon/c_random.h"
#include "core/photon/photon_maps.h"
#include "core/photon/photon_tree.h"
#include "core/photon/settings.h"

namespace lentray::core {

class PhotonMap {
 public:
  enum class Place { kSurface, kMedia };
  /// `random`: decides at which photons the density is measured.
  PhotonMap(PhotonTree tree, Place place, const PhotonSettings& settings, CRandom& random);

  bool is_empty() const { return m_tree.is_empty(); }
  const PhotonTree& tree() const { return m_tree; }
  double radius() const { return m_radius; }
  /// Fills `found`; `spare` is a buffer. `normal` of the surface, or null.
  void gather(const Vec3& point, const Vec3* normal, FoundPhotons& found,
              FoundPhotons& spare) const;

 private:
  PhotonTree m_tree;
  PhotonSettings m_settings;
  double m_radius = 0.0;
};

/// All that lights a scene.
struct PhotonLight {
  PhotonMap surface, media;
};
std::shared_ptr<const PhotonLight> make_photon_light(PhotonMaps maps,
                                                     const PhotonSettings& settings);

}  // namespace lentray::core
