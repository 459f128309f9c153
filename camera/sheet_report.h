// What a user should know of a sheet before printing it: its size and resolution, where its lens data
// are from, what the eyes see of it from where, the parallax of the scene and the error of the lens
// model. One thread.
#pragma once

#include <string>
#include <vector>

#include "camera/lens_request.h"
#include "camera/lenticular.h"
#include "camera/parallax.h"
#include "camera/scene_probe.h"
#include "core/base/bounds.h"

namespace lentray::camera {

/// How far apart the pupils of a viewer's eyes are, mm.
inline constexpr double kEyesApart = 65.0;

/// `asked`: what the sheet was made from.
std::vector<std::string> report_of(const Lenticular& sheet, const LensRequest& asked);

/// Depths behind the sheet of what a coarse grid of its rays meets. Scene units.
struct VisibleDepths {
  double nearest = core::Bounds::kInf, farthest = -core::Bounds::kInf;
  bool open = false;  ///< some rays meet nothing
};
VisibleDepths visible_depths(const Lenticular& sheet, const SceneProbe& probe);
/// The nearest and the farthest visible point, and the background.
std::vector<std::string> depth_lines(const Lenticular& sheet, const VisibleDepths& seen);
/// What of them jumps from view to view.
std::vector<std::string> jump_warnings(const Lenticular& sheet, const VisibleDepths& seen);

/// What will be wrong with the sheet for eyes at the viewing distance that was asked for.
std::vector<std::string> viewing_warnings(const Lenticular& sheet, const LensRequest& asked);

}  // namespace lentray::camera
