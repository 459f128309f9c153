// What a compiled scene needs of the kernel and how it was laid out, for people
// (`lentray --explain`).
#pragma once

#include <string>

#include "core/scene/scene.h"

namespace lentray::core {

/// Several lines of text, each ended; the camera's part is told by the camera.
std::string explain(const Scene& scene);

}  // namespace lentray::core
