// What a layer of a surface makes of the photons that were gathered about it: each is a light of its own that
// comes from where the photon came from. World space; colours linear. Pure.
// Source: reference manual 3.7, "Photons"; the weights are those that replay stock's pictures
// (tests/image/photons_test.cpp).
#pragma once

#include "core/base/color.h"
#include "core/material/finish.h"
#include "core/photon/photon_tree.h"
#include "core/scene/scene.h"
#include "core/trace/ray_state.h"

namespace lentray::core {

/// A layer that is lit.
struct PhotonLitLayer {
  const Finish& finish;
  const Rgb& pigment;
  const Vec3& normal;  ///< of the layer, facing the ray
  double opacity;
  bool shines;  ///< highlights are wanted
  const Surface& surface;
};

Rgb light_of_photons(const PhotonTree& tree, const FoundPhotons& found, const PhotonLitLayer& layer,
                     const SceneSettings& settings);

}  // namespace lentray::core
