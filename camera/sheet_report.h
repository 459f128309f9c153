// What a user should know of a sheet before printing it: its size, resolution and the parallax of
// the scene, and where it would cut into objects. One thread.
#pragma once

#include <string>
#include <vector>

#include "camera/lenticular.h"
#include "camera/scene_probe.h"

namespace lentray::camera {

/// How far, in pixels of a view (one a lens), a point moves from one view to the next when it lies
/// `depth` scene units behind the sheet (negative: before it).
double parallax(const Lenticular& sheet, double depth);

std::vector<std::string> report_of(const Lenticular& sheet, const SceneProbe& probe);

/// Warnings: objects that the sheet, or the way of the eyes from the first view to the last, cuts.
std::vector<std::string> collisions_of(const Lenticular& sheet, const SceneProbe& probe);

}  // namespace lentray::camera
