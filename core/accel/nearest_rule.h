// Who wins where a ray meets two objects at one distance: the rule that all searches for the nearest hit share.
// Internal to core/accel. World space; pure functions.
#pragma once

#include <bit>
#include <cstdint>

#include "core/accel/object_tree.h"
#include "core/base/ray.h"

namespace lentray::core {

/// The double after a distance, which is positive and finite.
inline double next_up(double t) {
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(t) + 1);
}

/// The object whose box the ray enters first: what is left before what is entered. Then the object first in the
/// scene, infinite ones before others.
bool wins_tie(const ObjectEntry& e, const ObjectEntry& over, const Ray& ray);

}  // namespace lentray::core
