// What is said and drawn of a lens sheet's depth. One thread.
#pragma once

#include <atomic>
#include <optional>
#include <string>

#include "core/render/progress.h"
#include "tools/session/session.h"

namespace lentray::tool {

struct DepthText {
  std::string report;   ///< lines
  std::string drawing;  ///< SVG; empty unless it was asked for
};

/// Looks at the scene through a setup that has a lens sheet. `title` of the drawing; null: none is asked
/// for. `threads`: 0: all of the machine. Nothing: it was cancelled.
std::optional<DepthText> depth_text(const Session& session, const CameraSetup& setup,
                                    const std::string* title, int threads,
                                    const std::atomic<bool>& cancel, core::Progress* progress);

}  // namespace lentray::tool
