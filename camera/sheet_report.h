// What a user should know of a sheet before printing it: its size, resolution, the parallax of the
// scene and the error of the lens model. One thread.
#pragma once

#include <string>
#include <vector>

#include "camera/lenticular.h"
#include "camera/scene_probe.h"

namespace lentray::camera {

/// The part of a print pixel by which a lens model may differ from Snell's law and still be called
/// good enough in the report.
inline constexpr double kModelTolerance = 0.25;

/// How far, in pixels of a view (one a lens), a point moves from one view to the next when it lies
/// `depth` scene units behind the sheet (negative: before it). Positive behind the sheet, where
/// things move along with the eye. Infinite depths have one when V is finite.
double parallax(const Lenticular& sheet, double depth);

std::vector<std::string> report_of(const Lenticular& sheet, const SceneProbe& probe);

}  // namespace lentray::camera
