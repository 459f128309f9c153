// What the open air on a ray's way between two surfaces makes of the light that comes along it: fog and
// rainbows. Media are core/trace/media_light.h. World space. Immutable; any number of threads.
// Source: reference manual 3.7, "Fog", "Rainbow".
#pragma once

#include <cstdint>

#include "core/base/segment.h"
#include "core/scene/atmosphere.h"
#include "core/trace/radiance.h"

namespace lentray::core {

/// How far a ray goes that meets nothing.
inline constexpr double kOpenAir = 2e10;

/// Both change `light`, which enters at the segment's far end, into what leaves at the ray's origin.
/// Rainbows come first, then media, then fogs. `key`: of the ray's random numbers, for
/// rainbows with jitter.
void pass_rainbows(const Atmosphere& air, const Segment& segment, std::uint64_t key,
                   Radiance& light);
void pass_fogs(const Atmosphere& air, const Segment& segment, Radiance& light);
/// What fogs leave of light that a shadow ray asks for.
Rgb left_by_fogs(const Atmosphere& air, const Segment& segment);

}  // namespace lentray::core
