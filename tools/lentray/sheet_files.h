// What a run writes about its lens sheet besides pictures: --depth, --depth-view, View_Cameras=. Of
// pictures of views of one sheet the first has them. One thread.
#pragma once

#include <atomic>
#include <string>

#include "parser/options/options.h"
#include "tools/session/camera_setup.h"
#include "tools/session/session.h"

namespace lentray::tool {

/// Where such a file goes, of a frame with its number in the name; empty: nowhere. "-": standard
/// output.
std::string sheet_file(const parser::RenderOptions& options, const std::string& file);

/// Throws camera::CameraError where --depth has nothing to say.
void check_depth(const CameraSetup& setup, const parser::RenderOptions& options);

/// The report on standard output, the drawing into the file, if there is one. A drawing for `-`
/// takes the report's place. Throws core::ImageError if it cannot be written. False: cancelled.
bool say_depth(const CameraSetup& setup, const Session& session,
               const parser::RenderOptions& options, const std::atomic<bool>& cancel);

/// Throws camera::CameraError where there is no lens sheet, core::ImageError if the file cannot be
/// written.
void write_view_cameras(const CameraSetup& setup, const parser::RenderOptions& options);

}  // namespace lentray::tool
