// A scene's descriptions as JSON: every member by its name, those that have their default left out.
// What several places share stands in full at the first, with an "id"; the others say "same_as".
// Numbers are the shortest that read back the same; JSON has no infinity or nan, they are strings.
// Locations are "file:line:column". Format: docs/language.md, "What a scene says, as JSON".
#pragma once

#include <nlohmann/json.hpp>

#include "parser/descriptions/scene.h"
#include "parser/source/source.h"

namespace lentray::parser {

nlohmann::ordered_json scene_json(const SceneDesc& scene, const SourceManager& sources);

}  // namespace lentray::parser
