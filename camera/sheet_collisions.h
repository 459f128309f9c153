// Where a sheet gets in the way of the scene: objects that lie across it, and objects that cut the
// places where its rays start. One thread.
#pragma once

#include <string>
#include <vector>

#include "camera/lenticular.h"
#include "camera/scene_probe.h"

namespace lentray::camera {

struct Collisions {
  std::vector<std::string> notes;     ///< normal: what is larger than the sheet runs through it
  std::vector<std::string> warnings;  ///< what the user may want to change
};

/// Warned of: objects that the sheet cuts, as far as they are no larger than it and can be seen
/// from the first, the middle or the last view; and any object in the way of the eyes from the
/// first view to the last (rays that start elsewhere: in the plane where they start).
/// Found with lines of sight, so what is thinner than a twenty-fourth of the sheet may go unseen.
Collisions collisions_of(const Lenticular& sheet, const SceneProbe& probe);

}  // namespace lentray::camera
