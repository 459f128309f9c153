// View_Cameras=: the cameras of a quilt's tiles, or of a lens sheet's views, as JSON for other programs. One thread.
#pragma once

#include <string>

#include "parser/options/options.h"
#include "tools/lentray/camera_setup.h"

namespace lentray::tool {

/// Where they go, of a frame with its number in the name; empty: nowhere. "-": standard output. Of pictures of views of
/// one sheet the first has the file.
std::string view_cameras_file(const parser::RenderOptions& options);

/// Throws camera::CameraError where there is no lens sheet, core::ImageError if the file cannot be written.
void write_view_cameras(const CameraSetup& setup, const parser::RenderOptions& options);

}  // namespace lentray::tool
