// The camera of a run: the scene's statement and the options together.
// Errors: camera::CameraError. One thread.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "camera/camera.h"
#include "camera/conversion.h"
#include "camera/lenticular.h"
#include "camera/scene_probe.h"
#include "parser/compile/camera.h"
#include "parser/options/options.h"

namespace lentray::tool {

struct CameraSetup {
  std::unique_ptr<camera::Camera> ordinary;    ///< or
  std::shared_ptr<camera::Lenticular> sheet;   ///< a lens sheet, and perhaps
  std::shared_ptr<const camera::Camera> view;  ///< one view of it, or a quilt of them
  std::unique_ptr<camera::Camera> blurred;     ///< the sheet or its view with an aperture, or null
  std::optional<camera::SheetStand> stand{};   ///< of a sheet that was made of a camera
  std::vector<std::string> report, warnings;

  const camera::Camera& camera() const {
    if (blurred) return *blurred;
    if (view) return *view;
    if (sheet) return *sheet;
    return *ordinary;
  }
};

CameraSetup make_camera(const parser::CameraRequest& request, const parser::RenderOptions& options,
                        const camera::SceneProbe& probe);

}  // namespace lentray::tool
