// Finds what a scene's parts need of the kernel. Used by Scene when it is compiled.
#pragma once

#include "core/scene/needs.h"
#include "core/scene/scene.h"

namespace lentray::core {

/// Notes of each object whether every surface of it stops all light: textures, interior textures,
/// and those of a mesh's faces.
void set_opacity(const std::vector<std::unique_ptr<Object>>& objects);

/// Objects must be split and their opacity set.
Needs find_needs(const SceneParts& parts);

/// As if the scene had everything; the counts of primitives stay.
Needs everything_needed(Needs found, const SceneSettings& settings);

}  // namespace lentray::core
