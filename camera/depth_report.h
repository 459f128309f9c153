// The report of --depth: how far what a sheet shows moves from view to view, how much of it the lenses
// show sharply, which objects stand out, and where the sheet would stand best. One thread.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "camera/conversion.h"
#include "camera/depth_survey.h"
#include "camera/lenticular.h"

namespace lentray::camera {

/// A place for the sheet where a near and a far depth move by as much.
struct BalancedStand {
  double distance = 0.0;      ///< Sheet_Distance; of a `lenticular` camera 0
  double moved = 0.0;         ///< of the sheet along its normal, scene units
  double nearest_step = 0.0;  ///< pixels a view, negative
  double farthest_step = 0.0;
};
/// Depths are behind the sheet as it stands now. `stand`: where that is; empty: it is `lenticular` in the
/// scene, and keeps its size. Nothing unless nearest < farthest.
std::optional<BalancedStand> balanced_stand(const Lenticular& sheet,
                                            const std::optional<SheetStand>& stand, double nearest,
                                            double farthest);

/// Lines of text. Those of lists are indented by two blanks.
std::vector<std::string> depth_report(const Lenticular& sheet,
                                      const std::optional<SheetStand>& stand,
                                      const DepthSurvey& seen);

}  // namespace lentray::camera
