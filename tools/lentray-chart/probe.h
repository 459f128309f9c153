// Finds out what a scene uses: by lentray --explain, and by small pictures where only a picture shows it.
// Errors: std::runtime_error with what lentray said of a scene that it cannot read. One thread.
#pragma once

#include "tools/lentray-chart/session.h"

namespace lentray::chart {

/// What lentray's --help=all names.
Abilities abilities_of(const Session& session);

/// Facts, files that were read, and size of the scene. `session.request` has the user's options and abilities.
void probe_scene(Session& session);

}  // namespace lentray::chart
