// What a layer of a surface makes of the photons that were gathered about it: each is a light of its own that
// comes from where the photon came from. World space; colours linear. Pure.
// Source: reference manual 3.7, "Photons"; the weights are those that replay stock's pictures
// (tests/image/photons_test.cpp).
#pragma once

#include "core/base/color.h"
#include "core/photon/photon_tree.h"
#include "core/scene/scene.h"
#include "core/trace/layer.h"
#include "core/trace/ray_state.h"

namespace lentray::core {

Rgb light_of_photons(const PhotonTree& tree, const FoundPhotons& found, const Layer& layer,
                     const Surface& at, const SceneSettings& settings);

}  // namespace lentray::core
