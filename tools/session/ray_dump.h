// --dump-rays: every camera ray as text, several of a pixel one after the other (docs/lens.md).
// Throws core::ImageError if the file cannot be written; what stood in its place is whole then.
#pragma once

#include <string>

#include "camera/camera.h"

namespace lentray::tool {

void dump_rays(const camera::Camera& camera, const std::string& path);

}  // namespace lentray::tool
