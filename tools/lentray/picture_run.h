// One picture, a still or a frame: read the scene unless the picture before has, place the camera,
// render, write. Everything that can be refused is refused before rendering starts. Messages go to
// standard error; warnings are said before rendering, and what comes later at the end. Errors, each
// worded for the user: parser::OptionError, parser::ParseError, camera::CameraError,
// core::ImageError. One thread calls.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "camera/composition.h"
#include "parser/options/animation.h"
#include "parser/options/options.h"
#include "tools/lentray/message_form.h"
#include "tools/lentray/run.h"
#include "tools/lentray/warnings.h"
#include "tools/session/scene_disk.h"

namespace lentray::tool {

/// A scene that was read, with what it was read from.
struct SceneInUse;

struct Picture {
  const parser::RenderOptions& options;
  const parser::FrameClock& clock;
  const std::string& scene;                     ///< path of the file
  std::shared_ptr<SceneInUse>& kept;            ///< of the picture before; becomes that of this one
  bool is_last = true;                          ///< the program ends after it
  bool is_frame = false;                        ///< of an animation
  std::optional<camera::SceneDepths> depths{};  ///< of all of it (tools/lentray/frame_depths.h)
  /// Called when all that the scene reads is known; what it throws ends the picture.
  std::function<void(const SceneDisk&)> is_read{};
};

/// Whether a run with these options makes pictures, rather than prints about the scene.
bool renders(const parser::RenderOptions& options);

Status run_picture(const Picture& picture, const std::atomic<bool>& cancel, MessageForm& form,
                   Warnings& warnings);

}  // namespace lentray::tool
