// The photons that were shot for a scene. World space. Plain values.
// Source: reference manual 3.7, "Photons".
#pragma once

#include <vector>

#include "core/photon/photon.h"

namespace lentray::core {

/// In the order in which they were shot.
struct PhotonMaps {
  std::vector<Photon> surface;  ///< on surfaces
  std::vector<Photon> media;    ///< in media
};

}  // namespace lentray::core
