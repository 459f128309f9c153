// The photons that were shot for a scene. World space. Plain values.
// Source: reference manual 3.7, "Photons".
#pragma once

#include <vector>

#include "core/photon/photon.h"

namespace lentray::core {

struct PhotonMaps {
  /// In the order of a PhotonTree, as files have them; else in the order in which they were shot.
  bool are_trees = false;
  std::vector<Photon> surface;  ///< on surfaces
  std::vector<Photon> media;    ///< in media
};

}  // namespace lentray::core
