// What a scene says of photons -> settings and targets of the kernel. World space.
// Source: reference manual 3.7, "Photons"; balls of targets are those that replay stock's files of photons
// (tests/image/photon_file_test.cpp).
#pragma once

#include <optional>

#include "core/scene/scene.h"
#include "parser/descriptions/global.h"
#include "parser/descriptions/object.h"
#include "parser/source/diagnostics.h"

namespace lentray::parser {

/// `settings` are complete but for photons. Empty: the scene has none.
std::optional<core::PhotonSettings> photon_settings(const GlobalDesc& global,
                                                    const core::SceneSettings& settings);

/// `outer` moves the statement into the world; `flags` are the object's, with what it inherits.
core::PhotonTarget photon_target(const ObjectDesc& object, const core::Transform& outer,
                                 const core::PassFlags& flags);

/// Warns of photons that cannot be shot, and drops them. Fails if they are too many to be shot.
void check_photons(const GlobalDesc& global, core::SceneParts& parts, Diagnostics& diagnostics);

}  // namespace lentray::parser
