// What a ray sees that hits nothing: sky_sphere over background. `direction` in world space, as
// it is (not necessarily unit).
// Source: reference manual 3.7, "Background", "Sky Sphere"; scenes below #version 3.7 filter by
// the older rule, as stock does.
#pragma once

#include "core/base/vec3.h"
#include "core/render/tracer.h"
#include "core/scene/scene.h"

namespace lentray::core {

Radiance sky_radiance(const Scene& scene, const Vec3& direction);

}  // namespace lentray::core
