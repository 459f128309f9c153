// --depth and --depth-view: what is said and drawn of a lens sheet's depth. One thread.
#pragma once

#include <atomic>
#include <cstddef>
#include <string>

#include "camera/scene_probe.h"
#include "parser/options/options.h"
#include "tools/lentray/camera_setup.h"

namespace lentray::tool {

struct DepthText {
  std::string report;   ///< lines
  std::string drawing;  ///< SVG; empty unless it was asked for
};

/// Where the drawing goes, of a frame with its number in the name; empty: nowhere. "-": standard output.
std::string depth_file(const parser::RenderOptions& options);

/// Of views of one sheet the first has the texts. Empty if it was cancelled. `levels`: the scene's
/// deepest(). Throws camera::CameraError where there is no lens sheet.
DepthText depth_of(const CameraSetup& setup, const camera::SceneProbe& probe,
                   const parser::RenderOptions& options, std::size_t levels,
                   const std::atomic<bool>& cancel);

/// The report on standard output, the drawing into the file, if there is one. A drawing for `-` takes
/// the report's place. Throws core::ImageError if it cannot be written.
void say_depth(const DepthText& text, const std::string& file);

}  // namespace lentray::tool
