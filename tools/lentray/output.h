// What a run leaves behind: the picture with its metadata, and the statistics file.
// Errors: core::ImageError. One thread.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "core/image/image.h"
#include "core/image/writer.h"
#include "core/scene/scene.h"
#include "parser/options.h"
#include "tools/lentray/camera_setup.h"

namespace lentray::tool {

core::FileType file_type(parser::OutputType type);

/// The picture to `path` ("-": standard output). Rendered in the scene's working space, which
/// `settings` tells; the picture is changed where that is not linear light nor a power of it.
void write_picture(core::Image& image, const std::string& path, parser::OutputType type,
                   const parser::RenderOptions& options, const core::SceneSettings& settings,
                   const CameraSetup& camera);

/// The camera's properties as JSON: the part below "lens", and vectors as arrays.
nlohmann::json lens_json(const camera::Camera& camera);

void write_text_file(const std::string& path, const std::string& text);

}  // namespace lentray::tool
