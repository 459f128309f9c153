// Whether gates matter in a picture: a test of what they hide proves nothing where they hide nothing.
#pragma once

#include <cstddef>
#include <string>

#include "core/base/vec3.h"

namespace lentray::test {

/// How many of 80 x 60 rays, from `eye` towards the origin and up to 40 degrees beside it, meet another
/// surface, or one elsewhere, once the gates of the scene's list of objects are open
/// (core/object/gated.h).
/// Errors: those of parser::read_descriptions and parser::build_scene. Threads: any number.
std::size_t rays_that_gates_turn_away(const std::string& sdl, const core::Vec3& eye);

}  // namespace lentray::test
