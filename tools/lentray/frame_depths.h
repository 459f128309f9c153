// One sheet for all frames of an animation: where it stands and how much depth it shows (camera/composition.h) follow
// from what the first, the middle and the last frame show. They are found before the first picture, and kept
// beside the pictures until the animation is finished, so that +C goes on with the same sheet.
// Errors: none; a frame that cannot be read counts for nothing here, its own picture says why. One thread.
#pragma once

#include <atomic>
#include <optional>
#include <string>

#include "camera/composition.h"
#include "parser/options/options.h"

namespace lentray::tool {

/// Nothing: it is no animation, or none whose sheet is composed.
std::optional<camera::SceneDepths> frame_depths(const parser::RenderOptions& options,
                                                const std::string& scene,
                                                const std::atomic<bool>& cancel);

/// As a line of an identity (tools/session/identity.h).
std::string depths_line(const camera::SceneDepths& depths);

/// The animation is finished.
void forget_frame_depths(const parser::RenderOptions& options);

}  // namespace lentray::tool
