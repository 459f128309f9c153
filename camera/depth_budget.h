// Depth_Budget: how much closer together the eyes of the views must stand so that no visible point moves
// by more than a given distance from one view to the next. One thread calls; surveys run on the probe's threads.
//
// The parallax of a point is proportional to the depth factor (LensParameters::depth_factor). Eyes that
// stand elsewhere may see other points, so the sheet is surveyed again with the factor that was found.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "camera/lens_request.h"
#include "camera/lenticular.h"
#include "camera/scene_probe.h"

namespace lentray::camera {

/// The sheet with such a lens.
using SheetMaker = std::function<std::unique_ptr<Lenticular>(const LensParameters&)>;

struct FittedDepth {
  double factor = 1.0;              ///< greater than 0, at most 1
  std::vector<std::string> report;  ///< what was done, and what of the background
};

/// The budget in pixels of a view.
double budget_pixels(const DepthBudget& budget, const LensParameters& lens);

/// Throws CameraError where a visible point is too near to the eyes
/// for any factor.
FittedDepth fit_depth(const DepthBudget& budget, const LensParameters& lens, const SheetMaker& make,
                      const SceneProbe& probe);

}  // namespace lentray::camera
