// What a ray sees that hits nothing: sky_sphere over background. `direction` in world space, as
// it is (not necessarily unit).
//
// With +UA (SceneSettings::alpha) what is seen is as opaque as sky and background are, premultiplied; before
// #version 3.7 it is clear, whatever they are. Behind a mirror the background is always opaque.
// Source: reference manual 3.7, "Background", "Sky Sphere"; scenes below #version 3.7 filter by
// the older rule: tests/image/file_types_test.cpp.
#pragma once

#include "core/base/vec3.h"
#include "core/scene/scene.h"
#include "core/trace/radiance.h"

namespace lentray::core {

/// `mirrored`: the ray was reflected on its way.
Radiance sky_radiance(const Scene& scene, const Vec3& direction, bool mirrored);

}  // namespace lentray::core
