// How far photons are gathered where the scene does not say: so that about as many are found as are wanted,
// and more where they lie unevenly. World space.
// Source: reference manual 3.7, "Photons", `radius`; the formulae replay stock's pictures.
#pragma once

#include "core/photon/c_random.h"
#include "core/photon/photon_tree.h"

namespace lentray::core {

/// The tree is not empty. 0: all photons lie at one place.
double surface_gather_radius(const PhotonTree& tree, int most, CRandom& random);
double media_gather_radius(const PhotonTree& tree, int most, CRandom& random);

}  // namespace lentray::core
