// What a run leaves behind besides the picture: the statistics file.
// Errors: core::ImageError. One thread.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "camera/camera.h"

namespace lentray::tool {

/// The camera's properties as JSON: the part below "lens", and vectors as arrays.
nlohmann::json lens_json(const camera::Camera& camera);

void write_text_file(const std::string& path, const std::string& text);

}  // namespace lentray::tool
