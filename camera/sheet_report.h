// What a user should know of a sheet before printing it: its size and resolution, where its lens data
// are from, what the eyes see of it from where, the parallax of the scene and the error of the lens
// model. One thread.
#pragma once

#include <string>
#include <vector>

#include "camera/lens_request.h"
#include "camera/lenticular.h"
#include "camera/scene_probe.h"

namespace lentray::camera {

/// How far, in pixels of a view (one a lens), a point moves from one view to the next when it lies
/// `depth` scene units behind the sheet (negative: before it). Positive behind the sheet, where
/// things move along with the eye. Infinite depths have one when V is finite.
double parallax(const Lenticular& sheet, double depth);

/// How far apart the pupils of a viewer's eyes are, mm.
inline constexpr double kEyesApart = 65.0;
/// Parallax from view to view, in pixels of a view, beyond which the eye sees jumps and double edges.
/// Source: pop3dart.com, "Depth: it's all about parallax and sequence length".
inline constexpr double kMostParallax = 1.5;

/// `asked`: what the sheet was made from.
std::vector<std::string> report_of(const Lenticular& sheet, const LensRequest& asked,
                                   const SceneProbe& probe);

/// What will be wrong with the sheet for eyes at the viewing distance that was asked for.
std::vector<std::string> viewing_warnings(const Lenticular& sheet, const LensRequest& asked);

}  // namespace lentray::camera
