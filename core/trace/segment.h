// What is on a ray's way between two surfaces, and what it makes of the light that comes along it: fog and
// rainbows, in the open. World space. Immutable; any number of threads.
// Source: reference manual 3.7, "Fog", "Rainbow".
#pragma once

#include "core/base/ray.h"
#include "core/scene/atmosphere.h"
#include "core/trace/radiance.h"
#include "core/trace/random_key.h"

namespace lentray::core {

/// How far a ray goes that meets nothing.
inline constexpr double kOpenAir = 1e7;

/// A piece of a ray from its origin on.
struct Segment {
  const Ray& ray;  ///< unit direction
  double length;
};

/// Changes `light`, which enters at the segment's far end, into what leaves at the ray's origin. `random`:
/// of the sample, for rainbows with jitter.
void pass_segment(const Atmosphere& air, const Segment& segment, SampleRandom& random,
                  Radiance& light);

}  // namespace lentray::core
