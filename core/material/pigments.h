// The kinds of pigment. Points are in the space of what holds the pigment: the world, or the space
// of the pattern whose map it is an entry of. Immutable.
// Source: reference manual 3.7, "Pigment"; compared with stock by tests/image/patterns_test.cpp.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "core/material/blend_map.h"
#include "core/material/pigment.h"
#include "core/material/placed_pattern.h"

namespace lentray::core {

using PigmentPtr = std::shared_ptr<const Pigment>;

PigmentPtr make_plain_pigment(const Colour& colour);
PigmentPtr make_colour_map_pigment(PlacedPattern pattern, BlendMap<Colour> map);
/// Entries are evaluated in the pattern's space.
PigmentPtr make_pigment_map_pigment(PlacedPattern pattern, BlendMap<PigmentPtr> map);
/// Weights need not sum to 1.
PigmentPtr make_average_pigment(Placement placement, BlendMap<PigmentPtr> map);
/// A pigment inside another space.
PigmentPtr make_placed_pigment(Placement placement, PigmentPtr pigment);
/// The same colours without filter and transmit (+Q0, +Q1).
PigmentPtr make_opaque_pigment(PigmentPtr pigment);
/// The grey of a pigment as a pattern.
PatternPtr make_pigment_pattern(PigmentPtr pigment);

}  // namespace lentray::core
