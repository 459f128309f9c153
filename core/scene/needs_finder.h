// Finds what a scene's parts need of the kernel. Used by Scene when it is compiled.
#pragma once

#include "core/scene/needs.h"
#include "core/scene/scene.h"

namespace lentray::core {

/// True when every surface of the object stops all light: textures, interior textures, and those
/// of a mesh's faces.
bool all_opaque(const Object& object);

/// Objects must be split and their opacity set.
Needs find_needs(const SceneParts& parts);

/// As if the scene had everything; the counts of primitives stay.
Needs everything_needed(Needs found, const SceneSettings& settings);

}  // namespace lentray::core
