// The least distances at which rays see anything, in scene units, before Scene::tolerance_scale()
// shrinks them. Source: measured on stock (tests/image/shading_lights_test.cpp).
#pragma once

namespace lentray::core {

/// Hits nearer than this to a ray's start are not seen, by any ray but shadow rays.
inline constexpr double kMinHitDistance = 1e-4;
/// Occluders nearer than this to either end of a shadow ray do not count.
inline constexpr double kShadowTolerance = 1e-3;

}  // namespace lentray::core
