// What fog and rainbows make of the light that comes along a piece of a ray outside all solids.
// World space. Immutable; any number of threads.
#pragma once

#include <functional>

#include "core/base/ray.h"
#include "core/render/tracer.h"
#include "core/scene/atmosphere.h"

namespace lentray::core {

/// How far a ray goes that meets nothing.
inline constexpr double kOpenAir = 1e7;

/// `random` gives numbers in 0..1, for rainbows with jitter.
void pass_air(const Atmosphere& air, const Ray& ray, double depth,
              const std::function<double()>& random, Radiance& light);

}  // namespace lentray::core
